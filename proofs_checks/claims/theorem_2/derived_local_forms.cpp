// Traction and slope next to one point, from the local equation. [Bal16, theorems 2, 3, 9, 10]

#include "proofs_checks/instruments/derived.hpp"
#include "symbolic/statements/local_form_statements.hpp"

namespace steadyslide::proofs_checks {
namespace {

const std::vector<symbolic::DecidedStatement>& local_forms() {
  static const std::vector<symbolic::DecidedStatement> all = symbolic::local_form_statements();
  return all;
}

Family ends(const std::string& theorem, bool free, bool two_frictions) {
  Family family{
      free ? "free end" : "edge",
      {theorem + (free ? "-free-" : "-edge-")},
      {"the sign of alpha: front and rear exchanged", "alpha missing in the power", "1/2 missing in the power",
       "sqrt(1+s^2) missing in the slope", "1/sqrt(1+s^2) in the slope", "the sign of the slope",
       "the power of the " + std::string(free ? "edge" : "free end") + " with this slope"}};
  if (two_frictions) {
    family.variants.emplace_back("the angle of the other side");
    family.variants.emplace_back("sqrt(1+s^2) of the other side in the slope");
  }
  return family;
}

Family wedge(std::vector<std::string> ids) {
  return {"wedge",
          std::move(ids),
          {"pi missing in the logarithm", "Heaviside's function on the other side", "the sign of alpha",
           "Heaviside's function missing", "1/(1+s^2) missing", "1/sqrt(1+s^2) in place of 1/(1+s^2)",
           "the slopes of the sides swapped", "a factor 2 in the logarithm"}};
}

Claim jumps_and_wedges() {
  const Family jump{
      "friction jump",
      {"theorem-2-jump"},
      {"beta of the other sign: front and rear exchanged", "alpha_l + alpha_r in place of beta",
       "amplitudes of the sides swapped", "1/sqrt(1+s^2) missing", "sqrt(1+s^2) in place of its reciprocal",
       "the sign of one amplitude", "|x|^(beta+1) with amplitudes of one sign", "1/2 added to beta"}};
  const Family both{"wedge and friction jump",
                    {"theorem-2-wedge-and-jump"},
                    {"[s] taken from right to left", "s_l + s_r in place of [s]",
                     "the constant on the right side alone", "a factor pi in the constant",
                     "the constant without its divisor", "the constant missing", "a logarithm with the constant"}};
  return derived(
      {"thm-02-local-forms", "[Bal16, theorem 2]: traction next to a jump, a wedge, both",
       "Inside the contact, next to `c`: where the friction jumps the traction has the term `-theta cos(pi alpha(x)) "
       "|x-c|^beta` with `beta = alpha_- - alpha_+`. Where the profile has a wedge as well, the constant "
       "`[psi_bar']/[s]` stands beside it. At a wedge under one friction value the traction has `([psi_bar']/(1+s^2)) "
       "(log|x-c|/pi + s H(x-c))`.",
       "Contact on both sides of `c`; brackets mean the value in front of `c` less that behind it; next to `c` the "
       "traction is a sum of powers of `|x-c|`, with logarithms; the amplitude `theta` is not determined by the local "
       "equation.",
       "The integral `(1/pi) PV int t/(x'-x) dx'` takes `|x-c|^lambda`, carried by one side, to `-cot(pi lambda) "
       "|x-c|^lambda` on that side and to `-+|x-c|^lambda/sin(pi lambda)` on the other one, up to one power series. "
       "With amplitudes `A_-` and `A_+` the equation leaves two linear conditions, whose determinant `1 + s_- s_+ + "
       "(s_+ - s_-) cot(pi lambda)` vanishes for `lambda = beta`, with `A_- : A_+ = cos(pi alpha_-) : cos(pi "
       "alpha_+)`, and for `lambda = beta + k` with `(-1)^k` times this ratio. Where `beta > 0` the power `beta - 1` "
       "is integrable as well; its amplitudes have opposite signs, and `t <= 0` excludes it. A jump of `psi_bar'` is "
       "met by a constant traction `A`, since `s A` jumps by `[s] A`; where `[s] = 0` it takes a logarithm, whose "
       "image under the integral jumps."},
      local_forms, {jump, both, wedge({"theorem-2-wedge"})});
}

Claim contact_ends() {
  return derived(
      {"thm-03-local-forms", "[Bal16, theorem 3]: traction and slope at the ends of contact",
       "At a left end of contact `t = -theta d^p` with `p = -1/2 - alpha` at an edge or step and `p = 1/2 - alpha` at "
       "a free end; at a right end `p = -1/2 + alpha` and `p = 1/2 + alpha`; `d` is the distance to the end. Beyond "
       "the end the slope `u_bar'` has a power of the same exponent, with the amplitude `-theta sqrt(1+s^2)` at a left "
       "and `theta sqrt(1+s^2)` at a right edge, `theta sqrt(1+s^2)` at a left and `-theta sqrt(1+s^2)` at a right "
       "free end. Everywhere `alpha` and `s` are those of the contact side.",
       "Contact on one side of the point, none on the other; the friction may jump there; next to the point the "
       "traction is a sum of powers of `d`, with logarithms.",
       "A traction `d^p` on one side must not leave a power of its own exponent in the equation on that side: `-cot(pi "
       "p) + s = 0` for contact in front of the end, so that `cot(pi p) = tan(pi alpha)` and `p = -+1/2 - alpha`; "
       "contact behind the end is the mirror image with `s -> -s`. On the side without contact the integral is "
       "`-d^p/sin(pi p)` left of a left end and `d^p/sin(pi p)` right of a right end, and `1/sin(pi p)` is "
       "`-sqrt(1+s^2)` at edges, `sqrt(1+s^2)` at free ends. The friction on that side multiplies no traction: it does "
       "not enter."},
      local_forms, {ends("theorem-3", false, true), ends("theorem-3", true, true)});
}

Claim logarithm() {
  return derived({"thm-09-local-forms", "[Bal16, theorem 9]: the logarithm at a wedge",
                  "At a wedge under one friction value `t = (D(x)/(1+s^2)) (log|x-c|/pi + s H(x-c))` + a function "
                  "analytic at `c`, where `D` is the polynomial `psi_bar'` in front of `c` less that behind it. So the "
                  "logarithms stop with the degree of `D`.",
                  "Contact on both sides of `c`, one friction value; `D` of degree 2 at most is examined; next to `c` "
                  "the traction is a sum of powers with logarithms.",
                  "`(1/pi) PV int log|x'|/(x'-x) dx'` has a jump at 0, by `pi`, and that of a step `H` has "
                  "`-log|x|/pi`. For `a log|x| + b H(x)` the equation leaves `(pi a + s b) H(x) + (s a - b/pi) "
                  "log|x|`, so that `b = pi s a` and `pi a (1+s^2)` is the jump of `psi_bar'`. Multiplication by `x` "
                  "changes the integral by a constant only, so that `D(0)` may be replaced by `D(x)`."},
                 local_forms, {wedge({"theorem-9", "theorem-9-three-orders"})});
}

Claim one_friction() {
  return derived(
      {"thm-10-local-forms", "[Bal16, theorem 10]: the ends of contact under constant friction",
       "Under one friction value the powers at the ends of contact are `-1/2 - alpha` and `-1/2 + alpha` at a left and "
       "a right edge, `1/2 - alpha` and `1/2 + alpha` at free ends; the slope `u_bar'` beyond has `sqrt(1+s^2)` times "
       "the amplitude, with the signs of theorem 3.",
       "Contact on one side of the point, none on the other; `s` constant; next to the point the traction is a sum of "
       "powers of the distance, with logarithms.",
       "As for theorem 3, with the same `s` on both sides: `cot(pi p) = tan(pi alpha)` on the left end and `cot(pi p) "
       "= -tan(pi alpha)` on the right one, which leaves `p = -+1/2 - alpha` and `p = -+1/2 + alpha`; beyond the end "
       "the integral has the factor `1/|sin(pi p)| = 1/cos(pi alpha) = sqrt(1+s^2)`."},
      local_forms, {ends("theorem-10", false, false), ends("theorem-10", true, false)});
}

}  // namespace

std::vector<Claim> derived_local_forms() { return {jumps_and_wedges(), contact_ends(), logarithm(), one_friction()}; }

}  // namespace steadyslide::proofs_checks
