#include "proofs_checks/instruments/solutions/corner_form.hpp"
#include "proofs_checks/kit/formula_claim.hpp"

namespace steadyslide::proofs_checks {
namespace {

CaseList<SolvedCorner> corners(const Context& context) {
  const Rational third(1, 3);
  std::vector<SolvedCorner> all{solved_corner("wedge", 2, 2, Polynomial({0, -1, 1}), Polynomial({0, third, 2}), 6)};
  if (!context.quick) {
    all.push_back(
        solved_corner("wedge without friction", 0, 0, Polynomial({0, -third, 1, -third}), Polynomial({0, 1, 1}), 6));
    all.push_back(solved_corner("curvature", 1, 1, Polynomial({0, 0, 1}), Polynomial({0, 0, 2}), 6));
  }
  return {all, std::to_string(all.size()) + " solved problems"};
}

CornerForm at_wedge(const SolvedCorner& c) {
  const Rational s = c.problem.coupled_friction(0);
  const Number over = numeric::to_real<Number>(1 / (1 + s * s));
  return {.log_factor = over / numeric::pi<Number>(), .step = {0, numeric::to_real<Number>(s) * over}};
}

}  // namespace

Claim thm_09_solved_wedge() {
  return formula_claim<SolvedCorner, CornerForm>("thm-09-solved-wedge")
      .cases(corners)
      .precision(Precision::at_least_fifty)
      .says(at_wedge)
      .checked([]<numeric::Real R>(Findings& findings, const CornerForm& form, const SolvedCorner& c,
                                   const Context& context) { check_corner(findings, form, c, context); })
      .wrong("H(c-x) instead of H(x-c)",
             [](CornerForm& form, const SolvedCorner&) { std::swap(form.step[0], form.step[1]); })
      .wrong("1/(1+s^2) missing",
             [](CornerForm& form, const SolvedCorner& c) {
               const Number s = numeric::to_real<Number>(c.problem.coupled_friction(0));
               form.log_factor *= 1 + s * s;
               form.step[1] *= 1 + s * s;
             })
      .wrong("the logarithm with the other sign", [](CornerForm& form, const SolvedCorner&) { form.log_factor *= -1; })
      .wrong("1/pi missing", [](CornerForm& form, const SolvedCorner&) { form.log_factor *= numeric::pi<Number>(); })
      .wrong("D(c) instead of D(x)", [](CornerForm& form, const SolvedCorner&) { form.continued = false; })
      .near_miss("the logarithm",
                 [](CornerForm& form, const Number& step, const SolvedCorner&) { form.log_factor *= 1 + step; })
      .near_miss("the constant", [](CornerForm& form, const Number& step, const SolvedCorner&) { form.limit += step; });
}

}  // namespace steadyslide::proofs_checks
