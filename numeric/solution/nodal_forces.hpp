#pragma once
// Consistent nodal forces of the tractions on the nodes of a mesh of the surface: with the shape functions N_i,
//
//   normal_i = -int t N_i dx   along +z, into the body,      tangential_i = int t_t N_i dx   along +x,
//
// per unit of thickness. The panels of the traction are divided at the ends of elements, and the power at the end of a
// panel is the weight of its rule, so there are only rounding errors. The sum of the forces is the load, and the sum of
// their moments is its moment.

#include <vector>

#include "model/surface_mesh.hpp"
#include "numeric/number/estimate.hpp"
#include "numeric/solution/piecewise_traction.hpp"

namespace steadyslide::numeric {

template <Real R>
struct NodalForce {
  Estimate<R> normal;
  Estimate<R> tangential;
};

/// Returns one force for each node. Throws InvalidData with field "nodes[i]", where i is the first or the last node, if
/// there is contact beyond that node.
template <Real R>
std::vector<NodalForce<R>> nodal_forces(const PiecewiseTraction<R>& traction, const SurfaceMesh& mesh);

}  // namespace steadyslide::numeric
