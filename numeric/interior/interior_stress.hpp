#pragma once
// The stresses below the surface and the displacement's gradient there, caused by the traction t of a solution, by whatever
// method, and t_t = -f t (f t sliding towards -x), at (x, z), z > 0 the depth: the field of half_plane_stress.hpp,
//
//   (sigma_xx, sigma_zz, sigma_xz) = (2/pi) int_K t(x') (s - r c)/d (c^2, s^2, c s) dx',
//   d^2 = (x-x')^2 + z^2,  c = (x-x')/d,  s = z/d,  r = t_t/t on each piece of the friction,
//
// and with Hooke's law and W of force_sums.hpp, mu the half-space's shear modulus, kappa Kolosov's constant [Mus63],
//
//   2 mu d u_x/dx = sigma_xx - (3-kappa)/4 (sigma_xx + sigma_zz),   2 mu d u_z/dz alike,
//   2 mu d u_z/dx = sigma_xz + (kappa+1)/2 W,                       2 mu d u_x/dz = sigma_xz - (kappa+1)/2 W.
//
// As z -> 0 at a point of contact: sigma_zz -> t, sigma_xz -> -t_t = -r t, and with u_t'/c = H t_t + gamma t
// [Bal16, (2)] sigma_xx -> t + 2 H t_t = (1 - 2 gamma) t + 2 u_t'/c; where one ratio r rules the whole contact that is
// t + 2 r (u'/c + gamma r t). d u_z/dx -> -u', the displacement u of contact problems pointing along -z, and d u_x/dx ->
// u_t', where the indenter is rigid. Off the contact sigma_zz and sigma_xz -> 0.
//
// A panel of the traction (piecewise_traction.hpp) that is at least its length away is its nodes' forces, many panels
// that are far away are their moments (force_sums.hpp), and a near one is cut at x and graded towards it with z as the
// smallest scale. Distances to x are sums from x, not differences of coordinates: nothing is lost however small z is. The
// work grows like log(number of panels) + log(length/z).
//
// What the errors estimate: rounding, the traction's own error, and free ends displaced by their own error e, which at a
// distance d from one changes what is nearest by about e/d. Of a cell that is its length away only the force counts, and by
// how much that may be displaced: errors of neighbours cancel, and what a coarser mesh has on the other side of a place is
// all that a point below can see.

#include <span>

#include "numeric/interior/force_sums.hpp"
#include "numeric/interior/stress_state.hpp"
#include "numeric/solution/contact_solution.hpp"
#include "numeric/solution/piecewise_traction.hpp"

namespace steadyslide::numeric {

template <Real R>
class InteriorStress {
 public:
  explicit InteriorStress(const ContactSolution<R>& solution) : InteriorStress(solution.piecewise_traction()) {}
  explicit InteriorStress(PiecewiseTraction<R> traction);

  const PiecewiseTraction<R>& traction() const { return traction_; }

  /// Depths whose squares R has with all digits.
  static bool reaches(const R& z) { return z * z >= std::numeric_limits<R>::min(); }
  /// No numbers, with infinite errors, at a depth that reaches() says R has not. Throw std::invalid_argument unless z > 0.
  StressState<R> at(const Rational& x, const Rational& z) const;
  /// At many points; spans of one length.
  void at(std::span<const R> x, std::span<const R> z, std::span<StressState<R>> states) const;

 private:
  /// Neighbouring panels, with moments where they are many.
  struct Cell {
    std::size_t first;
    std::size_t end;
    SurfacePlace<R> centre;
    R half;
    std::size_t children;  ///< the second one's index; the first one follows its parent. 0: none
    std::size_t moments;   ///< of the normal forces, then of the tangential ones
    R normal_error;
    R tangential_error;
    R normal_shift;  ///< sum of forces times by how much they may be displaced
    R tangential_shift;
  };
  struct Point {
    SurfacePlace<R> x;
    R z;
  };
  struct Sums : ForceSums<R> {
    TractionNodes<R> nodes;  ///< space for those of a panel
  };

  void gather(std::size_t first, std::size_t end);
  static const R& from_left(const TractionPanel<R>& panel, std::size_t node);
  void add_panel_moments(std::size_t panel, const Cell& cell, R* normal, R* tangential) const;
  /// The forces at the nodes of a panel's rule, and a factor of all of them.
  std::pair<const R*, R> forces_on(std::size_t panel) const;
  void add(std::size_t cell, const Point& point, Sums& sums) const;
  void add_panel(std::size_t panel, const Point& point, Sums& sums) const;
  void add_near(const TractionPanel<R>& panel, const R& x_left, const R& x_right, const R& z, Sums& sums) const;
  void add_part(const TractionPanel<R>& panel, const PanelPart<R>& part, const R& x_left, const R& x_right, const R& z,
                const R& reach, Sums& sums) const;
  StressState<R> state_of(const Sums& sums) const;
  StressState<R> at(const Point& point, Sums& sums) const;

  PiecewiseTraction<R> traction_;
  R poisson_ = 0;     ///< sigma_yy/(sigma_xx + sigma_zz)
  R trace_part_ = 0;  ///< (3-kappa)/4
  R rotation_ = 0;    ///< (kappa+1)/2
  R twice_shear_modulus_ = 0;
  std::vector<R> forces_;
  std::vector<std::size_t> first_force_;  ///< of each panel with more than a constant traction
  std::vector<Cell> cells_;
  std::vector<R> moments_;
};

}  // namespace steadyslide::numeric
