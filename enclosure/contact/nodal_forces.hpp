#pragma once
// Consistent nodal forces of the tractions on the nodes of a mesh of the surface: with the shape functions N_i,
//
//   normal_i = -int t N_i dx   along +z, into the body,      tangential_i = int t_t N_i dx   along +x,
//
// per unit of thickness, enclosed. Linear elements have nodes at their ends; quadratic ones have a third node in the
// middle.

#include <vector>

#include "enclosure/contact/enclosed_solution.hpp"

namespace steadyslide::enclosure {

struct NodalForce {
  Ball normal;
  Ball tangential;
};

/// Returns the forces. Throws InvalidData if the nodes do not increase, if a quadratic element's third node is missing
/// or not in its middle, or if contact may lie outside the mesh. A force is not finite if a node may be a free end of
/// contact.
std::vector<NodalForce> nodal_forces(const EnclosedSolution& solution, const std::vector<Rational>& nodes, int order);

}  // namespace steadyslide::enclosure
