#include "proofs_checks/instruments/solutions/corner_form.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"

namespace steadyslide::proofs_checks::thm_09_solved_wedge {
namespace {

CornerForm at_wedge(const SolvedCorner& c) {
  const Rational s = s_of(c.problem, 0);
  const auto over = to_real<Number>(1 / (1 + s * s));
  return {.log_factor = over / numeric::pi<Number>(), .step = {0, to_real<Number>(s) * over}};
}

}  // namespace

Claim claim() {
  const Rational third(1, 3);
  return corner_claim("thm-09-solved-wedge",
                      {solved_corner("wedge", 2, 2, Polynomial({0, -1, 1}), Polynomial({0, third, 2}), 6),
                       solved_corner("wedge without friction", 0, 0, Polynomial({0, -third, 1, -third}),
                                     Polynomial({0, 1, 1}), 6),
                       solved_corner("curvature", 1, 1, Polynomial({0, 0, 1}), Polynomial({0, 0, 2}), 6)},
                      1, at_wedge)
      .wrong("`H(c-x)` instead of `H(x-c)`", [](CornerForm& form) { std::swap(form.step[0], form.step[1]); })
      .wrong("`1/(1+s^2)` missing",
             [](CornerForm& form, const SolvedCorner& c) {
               const auto s = to_real<Number>(s_of(c.problem, 0));
               form.log_factor *= 1 + s * s;
               form.step[1] *= 1 + s * s;
             })
      .wrong("the logarithm with the other sign", [](CornerForm& form) { form.log_factor *= -1; })
      .wrong("`1/pi` missing", [](CornerForm& form) { form.log_factor *= numeric::pi<Number>(); })
      .wrong("`D(c)` instead of `D(x)`", &CornerForm::continued, false)
      .near_miss("the logarithm", &CornerForm::log_factor)
      .near_miss("the constant", [](CornerForm& form, const Number& step) { form.limit += step; });
}

}  // namespace steadyslide::proofs_checks::thm_09_solved_wedge
