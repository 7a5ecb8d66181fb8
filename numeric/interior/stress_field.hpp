#pragma once
// A field of stresses in the body: at points (interior_stress.hpp), or averaged (average_stress.hpp).

#include <span>
#include <vector>

#include "numeric/interior/stress_state.hpp"
#include "numeric/solution/piecewise_traction.hpp"

namespace steadyslide::numeric {

template <Real R>
class StressField {
 public:
  virtual ~StressField() = default;

  /// Returns the traction that causes the stresses.
  virtual const PiecewiseTraction<R>& traction() const = 0;
  /// Returns the length over which the stresses are averaged along x; 0 if they are not.
  virtual R window() const { return R(0); }
  /// Returns the depths of interfaces, at which stresses jump; a point on one belongs to the layer above.
  virtual std::vector<double> interfaces() const { return {}; }
  /// Computes the stresses at many points. The spans have the same length.
  virtual void at(std::span<const R> x, std::span<const R> z, std::span<StressState<R>> states) const = 0;
  /// Returns the stresses at a point without the errors that coarser meshes show.
  virtual StressState<R> on_finest_mesh(const R& x, const R& z) const = 0;
};

}  // namespace steadyslide::numeric
