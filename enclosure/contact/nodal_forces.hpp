#pragma once
// Consistent nodal forces of the tractions on the nodes of a mesh of the surface: with the shape functions N_i,
//
//   normal_i = -int t N_i dx   along +z, into the body,      tangential_i = int t_t N_i dx   along +x,
//
// per unit of thickness, enclosed. Linear elements have the nodes at their ends, quadratic ones a third in their middle.

#include <vector>

#include "enclosure/contact/enclosed_solution.hpp"

namespace steadyslide::enclosure {

struct NodalForce {
  Ball normal;
  Ball tangential;
};

/// `nodes` increase. Throws InvalidData where they do not, where a quadratic element's third node is not in its middle or
/// missing, and where contact may lie outside the mesh. A force is not finite where a node may be a free end of contact.
std::vector<NodalForce> nodal_forces(const EnclosedSolution& solution, const std::vector<Rational>& nodes, int order);

}  // namespace steadyslide::enclosure
