#pragma once
// Consistent nodal forces of the tractions on the nodes of a mesh of the surface: with the shape functions N_i,
//
//   normal_i = -int t N_i dx   along +z, into the body,      tangential_i = int t_t N_i dx   along +x,
//
// per unit of thickness. The panels of the traction are cut at the ends of elements, and the power at the end of a panel is
// its rule's weight: nothing but rounding is left. The forces sum up to the load, and their moments to its moment.

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

/// One for each node. Throws InvalidData of "nodes[i]", the first or the last one, beyond which there is contact.
template <Real R>
std::vector<NodalForce<R>> nodal_forces(const PiecewiseTraction<R>& traction, const SurfaceMesh& mesh);

}  // namespace steadyslide::numeric
