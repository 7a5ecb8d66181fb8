#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim parabola_derived() {
  const std::string against = "parabola against an edge";
  return derived(
      "parabola-derived", decided_riemann_hilbert,
      {{"contact zone",
        {"rh-parabola-zone"},
        {"the mirrored zone", "the centred zone", "1/4 + alpha^2", "a^2 without the 2", "a^2 without pi",
         "alpha for 2 alpha"}},
       {"largest pressure", {"rh-parabola-peak"}, {"4 alpha a", "-2 alpha a, the middle", "0", "-alpha a"}},
       {"printed factors",
        {"rh-parabola-traction"},
        {"1/4 + alpha^2", "without 1/sqrt(1+s^2)", "powers exchanged", "2/R", "t of the other sign"}},
       {"jumps, free ends",
        {"rh-parabola-jumps"},
        {"beta of the other sign", "sum p r^2 = P R/pi", "sum p r of the other sign", "r^2 not from the vertex"}},
       {against,
        {"rh-parabola-left-edge", "rh-parabola-right-edge"},
        {"beta of the other sign", "P R/pi for 2 P R/pi", "N = (x - v - sigma_1)/R", "without sigma_1^2"}},
       {"parabola in full contact",
        {"rh-parabola-two-edges"},
        {"beta of the other sign", "without the 1/2", "x - sigma_1", "without sigma_1^2", "the load's other sign"}}});
}

}  // namespace steadyslide::proofs_checks
