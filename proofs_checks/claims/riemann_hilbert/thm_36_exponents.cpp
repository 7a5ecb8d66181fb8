#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim thm_36_exponents() {
  const std::string edges = "Y's power at an edge on the ";
  return derived("thm-36-exponents", decided_riemann_hilbert,
                 {{"Plemelj's formulas and G",
                   {"rh-plemelj"},
                   {"Plemelj's sum with the other sign", "t = Phi- - Phi+", "Plemelj's sum without i",
                    "G = e^(2 pi i alpha)", "G = -e^(-2 pi i alpha)", "G = -e^(i pi alpha)"}},
                  {edges + "left",
                   {"rh-exponent-left-edge"},
                   {"-(1/2 - alpha)", "1/2 - alpha", "-1/2", "with the friction off the contact"}},
                  {edges + "right",
                   {"rh-exponent-right-edge"},
                   {"-(1/2 + alpha)", "1/2 + alpha", "-1/2", "with the friction off the contact"}},
                  {"Y's power at a free left end",
                   {"rh-exponent-left-free"},
                   {"1/2 + alpha", "-(1/2 + alpha)", "3/2 - alpha", "1/2"}},
                  {"Y's power at a free right end",
                   {"rh-exponent-right-free"},
                   {"1/2 - alpha", "-(1/2 - alpha)", "3/2 + alpha", "1/2"}},
                  {"Y's power at a friction jump",
                   {"rh-exponent-jump"},
                   {"alpha(c+) - alpha(c-)", "alpha(c-) + alpha(c+)", "1/2 + alpha(c-) - alpha(c+)",
                    "1 + alpha(c-) - alpha(c+)", "0"}},
                  {"Y of a contact set",
                   {"rh-Y-"},
                   {"beta of the other sign", "without the jumps", "every alpha of the other sign",
                    "exponents from right to left"}}});
}

}  // namespace steadyslide::proofs_checks
