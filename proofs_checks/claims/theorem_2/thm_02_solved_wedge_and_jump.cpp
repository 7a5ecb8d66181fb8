#include "proofs_checks/instruments/solutions/corner_form.hpp"
#include "proofs_checks/kit/formula_claim.hpp"

namespace steadyslide::proofs_checks {
namespace {

CaseList<SolvedCorner> corners(const Context& context) {
  const Rational third(1, 3);
  std::vector<SolvedCorner> all{
      solved_corner("wedge, friction rises", third, 3, Polynomial({0, -1, 1}), Polynomial({0, third, 2}), 6),
      solved_corner("wedge, friction falls", 3, third, Polynomial({0, -third, 1}), Polynomial({0, 1, 2}), 6)};
  if (!context.quick) {
    all.push_back(solved_corner("notch, friction rises", third, 3, Polynomial({0, Rational(1, 8), 1}),
                                Polynomial({0, 0, 1}), 12));
    all.push_back(solved_corner("wedge, friction falls, power of the other sign", 3, third, Polynomial({0, -3, 1}),
                                Polynomial({0, 3, 1}), 2, -1));
    all.push_back(
        solved_corner("curvature, friction falls", 3, third, Polynomial({0, 0, 1}), Polynomial({0, 0, 2}), 6));
  }
  return {all, std::to_string(all.size()) + " solved problems"};
}

CornerForm at_wedge_and_jump(const SolvedCorner& c) {
  const Rational rear = c.problem.coupled_friction(0);
  const Rational front = c.problem.coupled_friction(1);
  const Number constant = numeric::to_real<Number>(1 / (front - rear));
  return {.power = numeric::to_real<Number>(Exponent::angle(rear) - Exponent::angle(front)),
          .step = {constant, constant},
          .cosine = {numeric::cos_pi_alpha<Number>(rear), numeric::cos_pi_alpha<Number>(front)}};
}

}  // namespace

Claim thm_02_solved_wedge_and_jump() {
  return formula_claim<SolvedCorner, CornerForm>("thm-02-solved-wedge-and-jump")
      .cases(corners)
      .precision(Precision::at_least_fifty)
      .says(at_wedge_and_jump)
      .checked([]<numeric::Real R>(Findings& findings, const CornerForm& form, const SolvedCorner& c,
                                   const Context& context) { check_corner(findings, form, c, context); })
      .wrong("[s] of the other sign",
             [](CornerForm& form, const SolvedCorner&) {
               for (Number& constant : form.step) constant *= -1;
             })
      .wrong("beta = alpha_+ - alpha_-", [](CornerForm& form, const SolvedCorner&) { form.power *= -1; })
      .wrong("the constant D/[s] missing", [](CornerForm& form, const SolvedCorner&) { form.step = {}; })
      .wrong("cos(pi alpha) of the other side",
             [](CornerForm& form, const SolvedCorner&) { std::swap(form.cosine[0], form.cosine[1]); })
      .wrong("D(c)/[s] instead of D(x)/[s]", [](CornerForm& form, const SolvedCorner&) { form.continued = false; })
      .wrong("B(c) = +theta", [](CornerForm& form, const SolvedCorner&) { form.limit = -1; })
      .near_miss("beta", [](CornerForm& form, const Number& step, const SolvedCorner&) { form.power += step; })
      .near_miss("theta", [](CornerForm& form, const Number& step, const SolvedCorner&) { form.limit += step; });
}

}  // namespace steadyslide::proofs_checks
