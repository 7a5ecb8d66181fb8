#pragma once
// The stresses and the displacement gradient below the surface, at (x, z) with depth z > 0, under the traction t of a
// solution (of any method) and t_t = -f t (f t for sliding towards -x). This is the field of half_plane_stress.hpp,
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
// [Bal16, (2)] sigma_xx -> t + 2 H t_t = (1 - 2 gamma) t + 2 u_t'/c; if one ratio r holds in the whole contact, this is
// t + 2 r (u'/c + gamma r t). d u_z/dx -> -u', the displacement u of contact problems pointing along -z, and d
// u_x/dx -> u_t', where the indenter is rigid. Outside the contact sigma_zz and sigma_xz -> 0.
//
// A panel of the traction (piecewise_traction.hpp) at a distance of at least its length is replaced by the forces at
// its nodes. Many far panels are replaced by their moments (force_sums.hpp). A near panel is divided at x and graded
// towards x, with z as the smallest scale. Distances to x are sums that start at x, not differences of coordinates, so
// no digits are lost for small z. The cost grows like log(number of panels) + log(length/z).
//
// The errors contain: rounding, the error of the traction, and the error e in the position of a free end, which at a
// distance d from that end changes the traction by about e/d. For a cell at a distance of at least its length, only its
// force and the possible displacement of that force matter. The errors of neighbouring cells cancel: for a point below,
// a coarser mesh only moves some force to the other side of a place.

#include <span>

#include "numeric/interior/force_sums.hpp"
#include "numeric/interior/hookes_law.hpp"
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

  /// True if R can represent the square of the depth with all digits.
  static bool reaches(const R& z) { return z * z >= std::numeric_limits<R>::min(); }
  /// Return NaN with infinite errors if reaches(z) is false. Throw std::invalid_argument unless z > 0.
  StressState<R> at(const Rational& x, const Rational& z) const;
  /// Computes the stresses at many points. The spans have the same length.
  void at(std::span<const R> x, std::span<const R> z, std::span<StressState<R>> states) const;

 private:
  /// A group of neighbouring panels; a large group has moments.
  struct Cell {
    std::size_t first;
    std::size_t end;
    SurfacePlace<R> centre;
    R half;
    std::size_t children;  ///< index of the second child; the first child follows its parent; 0: none
    std::size_t moments;   ///< moments of the normal forces, then of the tangential ones
    R normal_error;
    R tangential_error;
    R normal_shift;  ///< sum of force times possible displacement
    R tangential_shift;
  };
  struct BodyPoint {
    SurfacePlace<R> x;
    R z;
  };
  struct Sums : ForceSums<R> {
    TractionNodes<R> nodes;  ///< work space for the nodes of a panel
  };

  void gather(std::size_t first, std::size_t end);
  static const R& from_left(const TractionPanel<R>& panel, std::size_t node);
  void add_panel_moments(std::size_t panel, const Cell& cell, R* normal, R* tangential) const;
  /// Returns the forces at the nodes of a panel's rule, and a common factor.
  std::pair<const R*, R> forces_on(std::size_t panel) const;
  void add(std::size_t cell, const BodyPoint& point, Sums& sums) const;
  void add_panel(std::size_t panel, const BodyPoint& point, Sums& sums) const;
  void add_near(const TractionPanel<R>& panel, const R& x_left, const R& x_right, const R& z, Sums& sums) const;
  void add_part(const TractionPanel<R>& panel, const PanelPart<R>& part, const R& x_left, const R& x_right, const R& z,
                const R& reach, Sums& sums) const;
  StressState<R> state_of(const Sums& sums) const;
  StressState<R> at(const BodyPoint& point, Sums& sums) const;

  PiecewiseTraction<R> traction_;
  HookesLaw<R> law_;
  std::vector<R> forces_;
  std::vector<std::size_t> first_force_;  ///< for each panel whose traction is not constant
  std::vector<Cell> cells_;
  std::vector<R> moments_;
};

}  // namespace steadyslide::numeric
