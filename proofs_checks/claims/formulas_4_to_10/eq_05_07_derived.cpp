#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim eq_05_07_derived() {
  return derived("eq-05-07-derived", decided_riemann_hilbert,
                 {{"flat punch",
                   {"rh-flat-punch-1", "rh-flat-punch-2", "rh-flat-punch-3", "rh-flat-punch-4"},
                   {"edges exchanged", "every alpha of the other sign", "1/2 for 1/2 + alpha at the left edge",
                    "without 1/sqrt(1+s^2)", "without 1/pi", "t of the other sign", "beta of the other sign",
                    "cos(pi alpha) of one side on both"}}});
}

}  // namespace steadyslide::proofs_checks
