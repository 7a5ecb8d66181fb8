#include "proofs_checks/instruments/solutions/corner_form.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"

namespace steadyslide::proofs_checks::thm_02_solved_wedge_and_jump {
namespace {

CornerForm at_wedge_and_jump(const SolvedCorner& c) {
  const Rational rear = s_of(c.problem, 0);
  const Rational front = s_of(c.problem, 1);
  const auto constant = to_real<Number>(1 / (front - rear));
  return {.power = to_real<Number>(Exponent::angle(rear) - Exponent::angle(front)),
          .step = {constant, constant},
          .cosine = {cos_pi_alpha<Number>(rear), cos_pi_alpha<Number>(front)}};
}

}  // namespace

Claim claim() {
  const Rational third(1, 3);
  return corner_claim(
             "thm-02-solved-wedge-and-jump",
             {solved_corner("wedge, friction rises", third, 3, Polynomial({0, -1, 1}), Polynomial({0, third, 2}), 6),
              solved_corner("wedge, friction falls", 3, third, Polynomial({0, -third, 1}), Polynomial({0, 1, 2}), 6),
              solved_corner("notch, friction rises", third, 3, Polynomial({0, Rational(1, 8), 1}),
                            Polynomial({0, 0, 1}), 12),
              solved_corner("wedge, friction falls, power of the other sign", 3, third, Polynomial({0, -3, 1}),
                            Polynomial({0, 3, 1}), 2, -1),
              solved_corner("curvature, friction falls", 3, third, Polynomial({0, 0, 1}), Polynomial({0, 0, 2}), 6)},
             2, at_wedge_and_jump)
      .wrong("`[s]` of the other sign",
             [](CornerForm& form) { std::ranges::for_each(form.step, [](Number& constant) { constant *= -1; }); })
      .wrong("`beta = alpha_+ - alpha_-`", [](CornerForm& form) { form.power *= -1; })
      .wrong("the constant `D/[s]` missing", [](CornerForm& form) { form.step = {}; })
      .wrong("`cos(pi alpha)` of the other side", [](CornerForm& form) { std::swap(form.cosine[0], form.cosine[1]); })
      .wrong("`D(c)/[s]` instead of `D(x)/[s]`", &CornerForm::continued, false)
      .wrong("`B(c) = +theta`", &CornerForm::limit, -1)
      .near_miss("`beta`", [](CornerForm& form, const Number& step) { form.power += step; })
      .near_miss("`theta`", [](CornerForm& form, const Number& step) { form.limit += step; });
}

}  // namespace steadyslide::proofs_checks::thm_02_solved_wedge_and_jump
