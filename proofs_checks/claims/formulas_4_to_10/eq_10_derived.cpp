#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim eq_10_derived() {
  return derived("eq-10-derived", decided_riemann_hilbert,
                 {{"inverse",
                   {"rh-inversion-"},
                   {"the integral's other sign", "the load's other sign", "s u' for s u'/(1+s^2)",
                    "1/sqrt(1+s^2) for 1/(1+s^2) before the integral", "alpha of the other sign in the weight"}}});
}

}  // namespace steadyslide::proofs_checks
