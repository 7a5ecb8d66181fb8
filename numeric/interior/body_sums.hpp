#pragma once
// Sums of a kernel (force_sums.hpp) over the normal and the tangential forces of a traction, at points of the body.
//
// A panel of the traction (piecewise_traction.hpp) at a distance of at least its length is replaced by the forces at
// its nodes. Many far panels are replaced by their moments. A near panel is divided at x and graded towards x, with z as
// the smallest scale. Distances to x are sums that start at x, not differences of coordinates, so no digits are lost for
// small z. The cost grows like log(number of panels) + log(length/z).
//
// The errors contain rounding, the error of the traction, and the error e in the position of a free end, which at a
// distance d from that end changes the traction by about e/d. They do not contain the error of a mesh of cells: this is
// shown by other meshes (mesh_error.hpp).

#include "numeric/interior/force_sums.hpp"
#include "numeric/solution/mesh_error.hpp"
#include "numeric/solution/piecewise_traction.hpp"

namespace steadyslide::numeric {

template <Real R, class Kernel>
class BodySums {
 public:
  /// `unit` is the length in which the kernel measures.
  BodySums(PiecewiseTraction<R> traction, const R& unit);

  const PiecewiseTraction<R>& traction() const { return traction_; }

  /// Returns the sums at a point, which are 0 without contact. `nodes` is work space.
  ForceSums<R> at(const SurfacePlace<R>& x, const R& z, TractionNodes<R>& nodes) const;

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
  };
  struct BodyPoint {
    SurfacePlace<R> x;
    R z;
  };
  struct Sums : ForceSums<R> {
    TractionNodes<R>& nodes;
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

  PiecewiseTraction<R> traction_;
  R per_unit_;
  std::vector<R> forces_;
  std::vector<std::size_t> first_force_;  ///< for each panel whose traction is not constant
  std::vector<Cell> cells_;
  std::vector<R> moments_;
};

/// Returns the sums for a traction and for its coarser ones, the finest first.
template <Real R, class Kernel>
std::vector<BodySums<R, Kernel>> nested_sums(PiecewiseTraction<R> traction, const R& unit) {
  const std::vector<PiecewiseTraction<R>> coarser = traction.coarser();
  std::vector<BodySums<R, Kernel>> result;
  result.emplace_back(std::move(traction), unit);
  for (const PiecewiseTraction<R>& one : coarser) result.emplace_back(one, unit);
  return result;
}

}  // namespace steadyslide::numeric
