#include "symbolic/local/coupling.hpp"

namespace steadyslide::symbolic {

using GiNaC::ex;

ex coupling_constant(const ex& nu, Plane plane) {
  return plane == Plane::strain ? (1 - 2 * nu) / (2 * (1 - nu)) : (1 - nu) / 2;
}

ex compliance(const ex& nu, const ex& young, Plane plane) {
  return plane == Plane::strain ? 2 * (1 - nu * nu) / young : 2 / young;
}

KolosovSolid kolosov_solid(const ex& nu, const ex& young, Plane plane) {
  return {young / (2 * (1 + nu)), plane == Plane::strain ? 3 - 4 * nu : (3 - nu) / (1 + nu)};
}

ex dundurs_constant(const KolosovSolid& half_space, const KolosovSolid& indenter) {
  return (indenter.mu * (half_space.kappa - 1) - half_space.mu * (indenter.kappa - 1)) /
         (indenter.mu * (half_space.kappa + 1) + half_space.mu * (indenter.kappa + 1));
}

ex compliance(const KolosovSolid& solid) { return (solid.kappa + 1) / (4 * solid.mu); }

}  // namespace steadyslide::symbolic
