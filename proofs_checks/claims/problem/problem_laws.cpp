// What leaves the contact problem unchanged, and what changes its solution in a known way. [Bal16, section 2, (3)]

#include "proofs_checks/claims/problem/problem_parts.hpp"
#include "proofs_checks/instruments/problem_law.hpp"

namespace steadyslide::proofs_checks {
namespace {

const Rational factor(5, 3);
Claim law_claim(ClaimText text, const Law& right, std::vector<Wrong<Law>> wrong) {
  return make_claim(std::move(text), check_law, right, std::move(wrong));
}

/// The law with something in it changed.
template <class Change>
Wrong<Law> variant(std::string name, Law law, Change change) {
  change(law);
  return {std::move(name), law};
}

void miss_on_cells(Law& law) { law.missed_on_cells = true; }
void miss_of_load(Law& law) {
  law.miss = [](Law& l, const Rational& by) { l.load *= 1 + by; };
}
void miss_of_height(Law& law) {
  law.miss = [](Law& l, const Rational& by) { l.height *= 1 + by; };
}
void miss_of_traction(Law& law) {
  law.miss = [](Law& l, const Rational& by) { l.traction *= 1 + by; };
}
void miss_of_jump(Law& law) {
  law.miss = [](Law& l, const Rational& by) { l.jump = 100 * by; };
}

const std::string hypotheses =
    "any friction with jumps, any profile, attitude given; examined on random problems by the Riemann-Hilbert solver "
    "and on cells";

Claim translation_claim() {
  const Law law{.lift = Polynomial::constant(Rational(-7, 5))};
  return law_claim(
      {"eq-03-translation", "[Bal16, section 2]: the penetration is undetermined",
       "With `psi_bar + C` for `psi_bar` the solution has `u_bar + C` for `u_bar` and nothing else changes: neither "
       "the contact, nor the traction, nor the gap, nor `u'`. The load alone cannot say how deep the indenter sits",
       hypotheses,
       "Only `u_bar'` enters the equation, and only the difference `u_bar - psi_bar` the conditions of contact: both "
       "are what they were. `u_bar` itself is defined by `u_bar'` up to a constant, and no condition at infinity fixes "
       "it, because `u_bar` grows there like `(P/pi) log|x|`"},
      law,
      {variant("the gap grows with C", law, [](Law& l) { l.gap = Rational(7, 5); }),
       variant("a profile that is tilted instead of lifted", law,
               [](Law& l) {
                 l.lift = Polynomial({0, Rational(1, 100)});
               }),
       variant("the load changes, too", law, [](Law& l) { l.load = 2; }),
       variant("near miss: the traction moved by ten times the tolerance", law, miss_of_traction),
       variant("near miss: the traction on cells moved by ten times the tolerance", law, miss_on_cells)});
}

Claim dilation_claim() {
  const Law law{.scale = factor, .shift = Rational(1, 7), .height = factor, .load = factor, .gap = factor};
  return law_claim({"eq-03-dilation", "[Bal16, (3)]: the problem on a support of another length",
                    "If `t(x)`, `u_bar(x)` solve the problem with `psi_bar(x)`, `f(x)`, `P`, then `t(x/k)`, `k "
                    "u_bar(x/k)` solve it with `k psi_bar(x/k)`, `f(x/k)`, `k P`, and likewise after a shift of `x`",
                    hypotheses + "; `k > 0`",
                    "`(1/pi) PV int t(x'/k)/(x'-x) dx' = H t` at `x/k`, because `dx'/(x'-x)` does not change when all "
                    "lengths do; so `A` commutes with the dilation, `(k u_bar(x/k))' = u_bar'(x/k)`, the conditions of "
                    "contact are multiplied by `k > 0`, and `int t(x/k) dx = k int t dx`. A shift leaves `x'-x` alone"},
                   law,
                   {variant("heights kept", law, [](Law& l) { l.height = 1; }),
                    variant("load kept", law, [](Law& l) { l.load = 1; }),
                    variant("the traction divided by k", law, [](Law& l) { l.traction = 1 / factor; }),
                    variant("the gap kept", law, [](Law& l) { l.gap = 1; }),
                    variant("near miss: the load moved by ten times the tolerance", law, miss_of_load),
                    variant("near miss: the traction on cells moved by ten times the tolerance", law, miss_on_cells)});
}

Claim scaling_claim() {
  const Law law{.height = factor, .load = factor, .traction = factor, .gap = factor};
  return law_claim({"eq-03-scaling", "[Bal16, (3)]: load and profile multiplied together",
                    "If `t`, `u_bar` solve the problem with `psi_bar`, `P`, then `k t`, `k u_bar` solve it with `k "
                    "psi_bar`, `k P`: the contact stays what it is",
                    hypotheses + "; `k > 0`",
                    "The equation is linear. For `k > 0` the inequalities `u_bar + C <= psi_bar`, `t <= 0` are "
                    "multiplied by `k` and keep their sense, and `t (u_bar + C - psi_bar) = 0` is multiplied by `k^2`"},
                   law,
                   {variant("load kept", law, [](Law& l) { l.load = 1; }),
                    variant("profile kept", law, [](Law& l) { l.height = 1; }),
                    variant("the traction like k^2", law, [](Law& l) { l.traction = factor * factor; }),
                    variant("the traction kept", law, [](Law& l) { l.traction = 1; }),
                    variant("near miss: the profile moved by ten times the tolerance", law, miss_of_height),
                    variant("near miss: the traction on cells moved by ten times the tolerance", law, miss_on_cells)});
}

Claim mirror_claim() {
  const Law law{.scale = -1, .turned = true};
  return law_claim(
      {"eq-03-mirror", "[Bal16, (3)]: the indenter slides the other way",
       "With `psi_bar(-x)`, `f(-x)` and the other direction of sliding the solution is `t(-x)`, `u_bar(-x)`",
       hypotheses,
       "`x -> -x` turns `H t` into its negative, and `u_bar'` too; the shear along `+x` is `t_t = -f t` for one and "
       "`t_t = f t` for the other direction of sliding, so that `s` changes its sign with it. With all three signs "
       "turned the equation is the same; the other conditions do not know a direction"},
      law,
      {variant("the sliding direction kept", law, [](Law& l) { l.turned = false; }),
       variant("the direction turned, the data not mirrored", law, [](Law& l) { l.scale = 1; }),
       variant("the friction not mirrored", law, [](Law& l) { l.keeps_friction = true; }),
       variant("near miss: the heights moved by ten times the tolerance", law, miss_of_height),
       variant("near miss: the traction on cells moved by ten times the tolerance", law, miss_on_cells)});
}

Claim height_zero_claim() {
  const Law law{.jump = Rational(0)};
  return law_claim(
      {"eq-03-height-zero", "[Bal16, (3)]: a friction jump of height zero",
       "A place where `f` is said to jump by zero changes nothing: neither the contact, nor the traction, nor the gap",
       hypotheses,
       "`f` is the same function. In the solution `beta = alpha(c-) - alpha(c+) = 0` there: the factor `|x-c|^beta` is "
       "1, and the panels on both sides carry one analytic function"},
      law,
      {variant("a jump of 1/10", law, [](Law& l) { l.jump = Rational(1, 10); }),
       variant("the load changes, too", law, [](Law& l) { l.load = Rational(1001, 1000); }),
       variant("near miss: a jump a thousand times the tolerance", law, miss_of_jump),
       variant("near miss: the traction on cells moved by ten times the tolerance", law, miss_on_cells)});
}

}  // namespace

std::vector<Claim> problem_law_claims() {
  return {translation_claim(), dilation_claim(), scaling_claim(), mirror_claim(), height_zero_claim()};
}

}  // namespace steadyslide::proofs_checks
