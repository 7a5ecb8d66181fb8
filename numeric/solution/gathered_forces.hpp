#pragma once
// The forces of a traction at few places (numeric/layers/surface_forces.hpp).

#include "numeric/layers/surface_forces.hpp"
#include "numeric/solution/piecewise_traction.hpp"

namespace steadyslide::numeric {

/// The parts are not longer than `longest`. Functions that are analytic within this distance of a part are integrated to
/// rounding: their series converge like 4.2^-n. No parts without contact.
template <Real R>
SurfaceForces gathered_forces(const PiecewiseTraction<R>& traction, double longest);
/// Returns those of a traction and of its coarser ones, the finest first.
template <Real R>
std::vector<SurfaceForces> gathered_on_meshes(const PiecewiseTraction<R>& traction, double longest);

}  // namespace steadyslide::numeric
