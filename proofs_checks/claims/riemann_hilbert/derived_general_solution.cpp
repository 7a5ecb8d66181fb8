// The Riemann-Hilbert problem and its solution. [Bal16, theorem 36, reconstructed]

#include "proofs_checks/instruments/derived.hpp"

namespace steadyslide::proofs_checks {
namespace {

Claim exponents() {
  const std::string edges = "Y's power at an edge on the ";
  return derived(
      {"thm-36-exponents", "[Bal16, theorem 36], reconstructed: the Riemann-Hilbert problem",
       "On the contact `A t = psi_bar'` is `Phi^+ = G Phi^- + psi_bar'/(s+i)` with `G = (s-i)/(s+i) = -exp(2 pi i "
       "alpha)`, `Phi(z) = (1/(2 pi i)) int t(x')/(x'-z) dx'`. The function `Y(z) = prod_j (z-e_j)^{p_j}` satisfies "
       "`Y^+ = G Y^-` on the contact and `Y^+ = Y^-` off it, where `p = -(1/2+alpha)` at a left edge, `-(1/2-alpha)` "
       "at a right edge, `1/2-alpha` and `1/2+alpha` at a free left and right end, and `p = alpha(c-) - alpha(c+)` at "
       "a friction jump, `alpha` always on the contact side.",
       "Contact sets of one, two and three components with up to four friction jumps; the frictions are symbols, and "
       "in one case the numbers 1, 7, 3/4, -2/3, whose `sqrt(1+s^2)` are not independent.",
       "Plemelj's formulas are `t = Phi^+ - Phi^-` and `(1/pi) PV int t(x')/(x'-x) dx' = i (Phi^+ + Phi^-)`: put into "
       "`A t = psi_bar'` they give `(s+i) Phi^+ = (s-i) Phi^- + psi_bar'`. To the left of `e_j` the power "
       "`(z-e_j)^{p_j}` has the phases `exp(+-i pi p_j)` on both banks, so that crossing `e_j` multiplies `Y^+/Y^-` by "
       "`exp(-2 i pi p_j)`. At a left end this ratio goes from 1 to `G`, at a right end from `G` to 1, at a jump from "
       "one `G` to the other: this fixes `p_j` up to an integer, and the integer by the kind of the point: singular "
       "but integrable at an edge, zero of the traction at a free end, no singularity at a jump of height zero."},
      decided_riemann_hilbert,
      {{"Plemelj's formulas and G",
        {"rh-plemelj"},
        {"Plemelj's sum with the other sign", "t = Phi- - Phi+", "Plemelj's sum without i", "G = e^(2 pi i alpha)",
         "G = -e^(-2 pi i alpha)", "G = -e^(i pi alpha)"}},
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
        {"alpha(c+) - alpha(c-)", "alpha(c-) + alpha(c+)", "1/2 + alpha(c-) - alpha(c+)", "1 + alpha(c-) - alpha(c+)",
         "0"}},
       {"Y of a contact set",
        {"rh-Y-"},
        {"beta of the other sign", "without the jumps", "every alpha of the other sign",
         "exponents from right to left"}}});
}

Claim general_solution() {
  return derived(
      {"thm-36-general-solution", "[Bal16, theorem 36], reconstructed: its solution",
       "The exponents of `Y` sum to `S` = (free ends) - (components). On the contact `(s+i) Y^+ = epsilon |Y|/cos(pi "
       "alpha)`, `epsilon = +-1` constant on each component. `Phi = Y X` solves `A t = psi_bar'` if and only if `X^+ - "
       "X^- = epsilon cos(pi alpha) psi_bar'/|Y|`: `X` is the Cauchy integral of this, and a polynomial of degree "
       "`-S-1` at most. Unknowns and conditions are equally many: the free ends and the `-S` coefficients, against the "
       "load, the `S` moments and the gaps between components.",
       "Any number of components and, by induction, of jumps: a jump changes no sum and no sign. The equation itself "
       "is decided on two components with a jump in each.",
       "A component without jump contributes `-(1/2+alpha) - (1/2-alpha) = -1`, one more for each of its free ends, "
       "and one more jump next to the right end changes nothing, since `alpha_- - alpha_+` and `1/2 + alpha_+` sum to "
       "`1/2 + alpha_-`. On a panel `Y^+ = |Y| exp(i pi sigma)` with `sigma` the sum of the powers to its right, and "
       "`s+i = i exp(-i pi alpha)/cos(pi alpha)`; the product has the phase of `i exp(i pi (sigma - alpha))`, which is "
       "+1 next to a right edge, -1 next to a free right end, times `(-1)^m` where the powers of all components "
       "further right sum to `m`, and does not change at a jump. Dividing `Phi^+ - G Phi^- = psi_bar'/(s+i)` by `Y^+ = "
       "G Y^-` gives `X^+ - X^-`. With `n` components and `k` free ends `S = k - n`, and `k + max(0, -S) = 1 + max(0, "
       "S) + (n-1)`."},
      decided_riemann_hilbert,
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
      {"thm-36-polynomial-profile", "derived from [Bal16, theorem 36]: polynomial profiles",
       "Where `psi_bar'` is one polynomial on the whole contact no integral is left: `t = epsilon cos(pi alpha) |Y| (Q "
       "+ q)`, `Q` the polynomial part of `psi_bar'/Y` at infinity and `q` a polynomial of degree `-S-1` at most. The "
       "coefficients of `Q` and the conditions follow from the power sums `sigma_k = sum_j p_j e_j^k`.",
       "`psi_bar'` one polynomial on the whole contact, examined to degree 3 and for `-3 <= S <= 3`; any number of "
       "components and jumps, which enter by their power sums alone.",
       "`F = psi_bar' - Y N` with a polynomial `N` has `(F^+ + F^-)/2 + s (F^+ - F^-)/(2i) = psi_bar'` on the contact, "
       "because `(s+i) Y^+` is real there; `F` is `2i Phi` if it falls off as `P/(pi z)` at infinity, and then `t = "
       "(F^+ - F^-)/(2i) = epsilon cos(pi alpha) |Y| N`. So `N` is the polynomial part of `psi_bar'/Y`, plus `q`, "
       "whose coefficients the load and the gaps fix. The series of `Y` is `z^S prod_j (1 - e_j/z)^{p_j} = z^S "
       "exp(-sum_k sigma_k/(k z^k))`."},
      decided_riemann_hilbert,
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
