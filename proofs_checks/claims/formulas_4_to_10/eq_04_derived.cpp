#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim eq_04_derived() {
  return derived("eq-04-derived", decided_riemann_hilbert,
                 {{"flat punch",
                   {"rh-flat-punch-0", "rh-kernel"},
                   {"edges exchanged", "every alpha of the other sign", "1/2 for 1/2 + alpha at the left edge",
                    "without 1/sqrt(1+s^2)", "without 1/pi", "t of the other sign"}}});
}

}  // namespace steadyslide::proofs_checks
