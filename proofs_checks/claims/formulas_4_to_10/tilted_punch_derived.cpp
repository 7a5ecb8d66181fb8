#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim tilted_punch_derived() {
  return derived("tilted-punch-derived", decided_riemann_hilbert,
                 {{"tilted punch",
                   {"rh-tilted-punch"},
                   {"N = delta (x - sigma_1) - P/pi", "the load's other sign", "beta of the other sign", "without 1/pi",
                    "edges exchanged"}},
                  {"tilt at which an edge lifts",
                   {"rh-lifting-"},
                   {"the other sign", "the other end", "without pi", "half of it", "without sigma_1"}},
                  {"both tilts on [-1, 1]",
                   {"rh-tilted-punch-unit"},
                   {"exchanged", "alpha for 2 alpha", "P/pi and -P/pi", "both positive"}}});
}

}  // namespace steadyslide::proofs_checks
