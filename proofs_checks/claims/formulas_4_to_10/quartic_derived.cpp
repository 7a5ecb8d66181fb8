#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim quartic_derived() {
  return derived(
      "quartic-derived", decided_riemann_hilbert,
      {{"traction and conditions",
        {"rh-quartic"},
        {"-sigma_1 x", "h_2 = (sigma_2 - sigma_1^2)/2", "sigma_1^3/3 in h_3", "sigma_4/2 in h_4"}},
       {"middle and width",
        {"rh-quartic-ends"},
        {"alpha of the other sign", "the middle at 0", "10 alpha missing", "56 alpha^2 missing", "twice the load"}},
       {"without friction",
        {"rh-quartic-frictionless"},
        {"psi' = 4 x^3", "a^4 = 3/4", "a^2 for a^2/2", "half the pressure"}}});
}

}  // namespace steadyslide::proofs_checks
