// Closed forms, as what the solution of the Riemann-Hilbert problem gives for their profiles.

#include "proofs_checks/instruments/derived.hpp"

namespace steadyslide::proofs_checks {
namespace {

Family flat_punch(const std::string& about, std::vector<std::string> ids, bool jumps) {
  Family family{about,
                std::move(ids),
                {"edges exchanged", "every alpha of the other sign", "1/2 for 1/2 + alpha at the left edge",
                 "without 1/sqrt(1+s^2)", "without 1/pi", "t of the other sign"}};
  if (jumps) {
    family.variants.emplace_back("beta of the other sign");
    family.variants.emplace_back("cos(pi alpha) of one side on both");
  }
  return family;
}

Claim punch_without_jump() {
  return derived(
      {"eq-04-derived", "[Bal16, (4) and (8)]: flat punch under constant friction",
       "`t = -P t_0` with `t_0 = (cos(pi alpha)/pi) (1+x)^{-(1/2+alpha)} (1-x)^{-(1/2-alpha)}` has `A t = 0` and "
       "`int t = -P`, and is what the general solution of the Riemann-Hilbert problem gives in full contact.",
       "Flat punch on `]-1, 1[` in full contact with both edges; `s` constant, a symbol.",
       "With `psi_bar' = 0` and both ends edges `S = -1`: nothing but a constant is left in `Phi = C Y`, and "
       "`Y = (z+1)^{-(1/2+alpha)} (z-1)^{-(1/2-alpha)}` behaves as `1/z`, so that the load gives `C = P/(2 pi i)`. The "
       "jump `t = Phi^+ - Phi^- = (P/pi) |Y| sin(pi sigma)` with `sigma = -(1/2-alpha)` is `-(P/pi) cos(pi alpha) "
       "|Y|`."},
      decided_riemann_hilbert, {flat_punch("flat punch", {"rh-flat-punch-0", "rh-kernel"}, false)});
}

Claim punch_with_jumps() {
  return derived(
      {"eq-05-07-derived", "[Bal16, (5)-(7)]: flat punch with a friction jump; up to four jumps",
       "`t = -(P/pi) cos(pi alpha(x)) prod_j |x-e_j|^{p_j}` with `p = -(1/2+alpha_0)`, `alpha_{k-1} - alpha_k` at the "
       "jumps and `-(1/2-alpha_m)` has `A t = 0` and `int t = -P`, and is what the general solution gives; with one "
       "jump "
       "it is (5)-(7).",
       "Flat punch on `]-1, 1[` in full contact with both edges; 1 to 4 jumps at any places, frictions as symbols.",
       "As without jump, with a power `alpha_{k-1} - alpha_k` at each jump, where `Y^+/Y^-` goes from one `G` to the "
       "next. The powers sum to -1 whatever the jumps are, so that `C = P/(2 pi i)` stays; on the panel `k` the sum of "
       "the powers to the right is `sigma = -(1/2-alpha_k)`, and `t = (P/pi) |Y| sin(pi sigma)`."},
      decided_riemann_hilbert,
      {flat_punch("flat punch", {"rh-flat-punch-1", "rh-flat-punch-2", "rh-flat-punch-3", "rh-flat-punch-4"}, true)});
}

Claim inverse() {
  return derived(
      {"eq-10-derived", "[Bal16, (10)]: the inverse of the operator",
       "`t = s u_bar'/(1+s^2) - cos(pi alpha) |Y| (1/pi) PV int cos(pi alpha') u_bar'/(|Y| (x'-x)) dx' - P t_0` is "
       "`cos(pi alpha) |Y| (Q - P/pi)`, `Q` the polynomial part of `u_bar'/Y` at infinity; without a jump the first "
       "two "
       "terms are (10).",
       "Full contact on `]-1, 1[` with both edges; `u_bar' = 1, x, ..., x^4`, and so every polynomial of degree 4 at "
       "most; 0, 1 and 3 friction jumps, frictions as symbols.",
       "`V = u_bar'/Y - Q` vanishes at infinity, so it is the Cauchy integral of its own jump. On the contact "
       "`(V^+ - V^-)/(2i) = cos(pi alpha) u_bar'/|Y|`, hence `(1/pi) PV int cos(pi alpha') u_bar'/(|Y| (x'-x)) dx'` is "
       "`(V^+ + V^-)/2 = s cos(pi alpha) u_bar'/|Y| - Q`. Multiplied by `-cos(pi alpha) |Y|` this leaves "
       "`-s u_bar'/(1+s^2) + cos(pi alpha) |Y| Q`, and the first term of the formula takes the first of these away."},
      decided_riemann_hilbert,
      {{"inverse",
        {"rh-inversion-"},
        {"the integral's other sign", "the load's other sign", "s u' for s u'/(1+s^2)",
         "1/sqrt(1+s^2) for 1/(1+s^2) before the integral", "alpha of the other sign in the weight"}}});
}

Claim tilted_punch() {
  return derived(
      {"tilted-punch-derived", "derived: the tilted flat punch, with up to four jumps",
       "A flat punch with `psi_bar' = delta` in full contact has `t = cos(pi alpha) |Y| (delta (x + sigma_1) - P/pi)`, "
       "`sigma_1 = sum_j p_j e_j`. An edge at `e` lifts at `delta = P/(pi (e + sigma_1))`, where the traction is that "
       "of "
       "a free end; on `]-1, 1[` without jump at `delta = P/(pi (1+2 alpha))` in front and `-P/(pi (1-2 alpha))` at "
       "the "
       "rear.",
       "Full contact up to that tilt; 0 to 4 jumps, frictions and places as symbols.",
       "With both edges `S = -1`, so that `delta/Y = delta (z + sigma_1) + O(1/z)` gives `Q`, and `q = -P/pi`. At the "
       "tilt stated the factor is `delta (x - e)`: the power of the edge rises by one to that of a free end, and the "
       "condition that places a free end holds. For `p = -(1/2+alpha)` at -1 and `-(1/2-alpha)` at 1 one has "
       "`sigma_1 = 2 alpha`."},
      decided_riemann_hilbert,
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

Claim parabola() {
  const std::string against = "parabola against an edge";
  return derived(
      {"parabola-derived", "[Bal16, section 2]: Galin's parabola, and jumps inside its contact",
       "For `psi_bar = x^2/(2R)` under constant friction the contact is `[-(1+2 alpha) a, (1-2 alpha) a]` with "
       "`a^2 = P R/(2 pi (1/4-alpha^2))`, the pressure is largest at `x = -4 alpha a`, and both printed factors of the "
       "traction are equal. With jumps inside the contact `sum_j p_j r_j = 0` and `sum_j p_j r_j^2 = 2 P R/pi` place "
       "the "
       "free ends, `t = -(cos(pi alpha)/R) prod_j |x-r_j|^{p_j}`. Against one or two edges `R N` is `x - v + sigma_1`, "
       "or `(x-v) (x+sigma_1) + (sigma_2 + sigma_1^2)/2 - P R/pi`, with the vertex at `v`.",
       "One contact component; 0 to 4 jumps inside it, for free ends any number; all data as symbols.",
       "With two free ends `S = 1`: `psi_bar'/Y = 1/R + c_1/z + c_2/z^2 + ...` leaves `N = 1/R` and the conditions "
       "`c_1 = 0`, `c_2 = P/pi`. From `1/Y = z^{-1} exp(sigma_1/z + sigma_2/(2 z^2) + ...)` these are `sigma_1 = 0` "
       "and "
       "`sigma_2 = 2 P R/pi`; without a jump the powers `1/2-alpha`, `1/2+alpha` turn them into the zone stated. The "
       "peak is where `(1/2-alpha)/(x-r_0) + (1/2+alpha)/(x-r_1) = 0`. With one edge `S = 0`, with two `S = -1`, and "
       "`Q` has one or two terms more."},
      decided_riemann_hilbert,
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

Claim quartic() {
  return derived(
      {"quartic-derived", "derived: the quartic",
       "For `psi_bar' = kappa x^3` with free ends `t = -cos(pi alpha) |Y| kappa (x^2 + sigma_1 x + h_2)`, `h_3 = 0` "
       "and "
       "`kappa h_4 = P/pi`, where `sum_n h_n u^n = exp(sum_k sigma_k u^k/k)`, `sigma_k = sum_j p_j e_j^k`. Under "
       "constant "
       "friction these are a cubic for the middle of the contact and a quartic for its width; without friction, "
       "`kappa = 2/pi` and `P = 1`, the half-width is `a` with `a^4 = 4/3` and the pressure "
       "`(2/pi) (x^2 + a^2/2) sqrt(a^2-x^2)`.",
       "One contact component with two free ends; 0 to 2 jumps, for the conditions any number; all data as symbols.",
       "`S = 1`, and `psi_bar'/Y = kappa z^3 z^{-1} exp(sum_k sigma_k/(k z^k)) = kappa z^2 (1 + h_1/z + h_2/z^2 + "
       "...)`: "
       "its polynomial part is `N`, and the coefficients of `1/z` and `1/z^2` have to be 0 and `P/pi`. For the powers "
       "`1/2-alpha` and `1/2+alpha` at `(u-1) a` and `(u+1) a`, `h_3` is "
       "`a^3 (6 u^3 + 36 alpha u^2 + (36 alpha^2+9) u + 8 alpha^3 + 10 alpha)/6`. With `alpha = 0` this leaves `u = 0` "
       "and `(3/8) kappa a^4 = P/pi`."},
      decided_riemann_hilbert,
      {{"traction and conditions",
        {"rh-quartic"},
        {"-sigma_1 x", "h_2 = (sigma_2 - sigma_1^2)/2", "sigma_1^3/3 in h_3", "sigma_4/2 in h_4"}},
       {"middle and width",
        {"rh-quartic-ends"},
        {"alpha of the other sign", "the middle at 0", "10 alpha missing", "56 alpha^2 missing", "twice the load"}},
       {"without friction",
        {"rh-quartic-frictionless"},
        {"psi' = 4 x^3", "a^4 = 3/4", "a^2 for a^2/2", "half the pressure"}}});
}

}  // namespace

std::vector<Claim> derived_tractions() {
  return {punch_without_jump(), punch_with_jumps(), inverse(), tilted_punch(), parabola(), quartic()};
}

}  // namespace steadyslide::proofs_checks
