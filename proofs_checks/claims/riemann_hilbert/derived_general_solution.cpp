// The Riemann-Hilbert problem and its solution. [Bal16, theorem 36, reconstructed]

#include "proofs_checks/instruments/derived.hpp"

namespace steadyslide::proofs_checks {
namespace {

Claim exponents() {
  const std::string edges = "Y's power at an edge on the ";
  return derived(claim_text("thm-36-exponents"), decided_riemann_hilbert,
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

Claim general_solution() {
  return derived(
      claim_text("thm-36-general-solution"), decided_riemann_hilbert,
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

Claim polynomial_profile() {
  return derived(
      claim_text("thm-36-polynomial-profile"), decided_riemann_hilbert,
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

}  // namespace

std::vector<Claim> derived_general_solution() { return {exponents(), general_solution(), polynomial_profile()}; }

}  // namespace steadyslide::proofs_checks
