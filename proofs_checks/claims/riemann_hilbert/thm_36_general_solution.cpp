#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim thm_36_general_solution() {
  return derived(
      "thm-36-general-solution", decided_riemann_hilbert,
      {{"the sum of the exponents",
        {"rh-exponent-sum"},
        {"(components) - (free ends)", "(free ends)", "(free ends) + (components)", "2 (free ends) - (components)",
         "with beta of the other sign"}},
       {"(s+i) Y+ on the contact",
        {"rh-real"},
        {"beta of the other sign", "without cos", "sin for cos", "+1 at a free right end", "cos of the other side"}},
       {"the jump of X",
        {"rh-general-solution"},
        {"h without cos", "h of the other sign", "h doubled", "h = epsilon cos psi' |Y|", "sin for cos"}},
       {"unknowns and conditions",
        {"rh-count"},
        {"without the load", "a condition for every component", "S = n - k", "one coefficient more"}}});
}

}  // namespace steadyslide::proofs_checks
