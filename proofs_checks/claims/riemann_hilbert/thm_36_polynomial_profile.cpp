#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim thm_36_polynomial_profile() {
  return derived(
      "thm-36-polynomial-profile", decided_riemann_hilbert,
      {{"psi' - Y N",
        {"rh-polynomial-substitution"},
        {"t of the other sign", "sin for cos", "s of the other sign", "F = 2 psi' - Y N", "F = -Y N"}},
       {"the conditions at infinity",
        {"rh-polynomial-decay"},
        {"Y's series for that of 1/Y", "power sums without 1/k", "the load's other sign", "without q at S = -1"}},
       {"the series of Y",
        {"rh-power-sums"},
        {"exp(+...)", "p of the other sign", "e^(k+1) for e^k", "one point missing"}}});
}

}  // namespace steadyslide::proofs_checks
