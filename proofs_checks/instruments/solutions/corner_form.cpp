#include "proofs_checks/instruments/solutions/corner_form.hpp"

#include "proofs_checks/instruments/solutions/flanks.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"

namespace steadyslide::proofs_checks {
namespace {

template <class R>
struct SolvedAtCorner {
  Solved<R> solution;
  R x;      ///< c
  R theta;  ///< 0 if the friction does not jump
  R limit;  ///< limit of B at c
  std::size_t j = 0;
};

template <Real R>
SolvedAtCorner<R> solve_corner(const SolvedCorner& c) {
  SolvedAtCorner<R> found{solve<R>(c.problem), to_real<R>(corner), 0, 0};
  while (!found.solution->form().changes_polynomial(found.j)) ++found.j;
  for (const auto& point : found.solution->singular_points()) {
    if (point.x.value != found.x) continue;
    found.theta = point.intensity.value;
    found.limit = c.has_jump() ? R(-found.theta) : point.constant.value;
    return found;
  }
  // Nothing is singular there.
  found.limit = found.solution->at(corner).traction.right.value;
  return found;
}

/// Returns psi'_+ - psi'_- at x, with the polynomials on the two sides of c.
template <Real R>
R difference_of_slopes(const ContactProblem& problem, const R& c, const R& x) {
  return slope<R>(problem, R(c + 1), x) - slope<R>(problem, R(c - 1), x);
}

/// Returns B at the distance d from c.
template <Real R>
R regular_part(const SolvedAtCorner<R>& at_corner, const CornerForm& said, Side side, const R& d) {
  using std::log, std::pow;
  const R& c = at_corner.x;
  const R x = !said.continued ? c : side == Side::left ? R(c - d) : R(c + d);
  const std::size_t i = side == Side::left ? 0 : 1;
  R singular(said.step[i]);
  if (said.log_factor != 0) singular += R(said.log_factor) * log(d);
  const RiemannHilbertSolution<R>& solution = *at_corner.solution;
  return (traction_beside(solution, at_corner.j, side, d) -
          difference_of_slopes(solution.problem().problem(), c, x) * singular) /
         (R(said.cosine[i]) * pow(d, R(said.power)));
}

template <Real R>
void check_regular_part(Findings& findings, const SolvedAtCorner<R>& at_corner, const CornerForm& said) {
  using std::abs, std::max;
  std::vector<R> left, right;
  for (int i = 1; i <= extrapolation_values<R>; ++i) {
    left.push_back(regular_part(at_corner, said, Side::left, R(i * extrapolation_step<R>())));
    right.push_back(regular_part(at_corner, said, Side::right, R(i * extrapolation_step<R>())));
  }
  const auto compare = [&](const char* name, const R& a, const R& b) {
    findings.compare(name, a, b, max({R(abs(a)), R(abs(b)), R(1)}));
  };
  // A limit below 1 in size is compared with an absolute error of 1. A near miss moves it in the same unit.
  const R limit =
      at_corner.limit + R(said.limit - 1) * max(R(abs(at_corner.limit)), R(1)) * (at_corner.limit < 0 ? -1 : 1);
  compare("at c", extrapolated(left, 0), limit);
  compare("at c", extrapolated(right, 0), limit);
  for (const int to : {1, 2}) {
    compare("across", extrapolated(left, to), right[static_cast<std::size_t>(to - 1)]);
    compare("across", extrapolated(right, to), left[static_cast<std::size_t>(to - 1)]);
  }
}

/// Requires the signs that follow from t <= 0.
template <Real R>
void check_signs(Findings& findings, const SolvedAtCorner<R>& at_corner, const CornerForm& said,
                 const SolvedCorner& c) {
  const R d = difference_of_slopes(c.problem, at_corner.x, at_corner.x);
  if (!c.has_jump()) {
    findings.require(d >= 0, "a wedge in the contact that points away from the body");
    return;
  }
  const R constant = d * R(said.step[1]);
  const R& theta = at_corner.theta;
  if (said.power < 0 || constant == 0) findings.require(theta >= 0, "theta < 0 where t <= 0 forbids it");
  if (said.power > 0) findings.require(constant <= 0, "a positive constant where t <= 0 forbids it");
  findings.require((theta > 0) == (c.theta > 0), "theta has not the sign that this case is to show");
}

}  // namespace

SolvedCorner solved_corner(std::string name, const Rational& rear, const Rational& front, const Polynomial& left,
                           const Polynomial& right, const Rational& load, int theta) {
  FrictionProfile friction = rear == front ? FrictionProfile({rear}) : FrictionProfile({rear, front}, {corner});
  return {std::move(name), flanks(std::move(friction), left, right, load), theta};
}

std::string text_of(const SolvedCorner& c) { return c.name + ": " + text_of(c.problem); }

FormulaClaim<SolvedCorner, CornerForm> corner_claim(std::string id, std::vector<SolvedCorner> corners,
                                                    std::size_t quick, CornerForm (*formula)(const SolvedCorner&)) {
  return formula_claim<SolvedCorner, CornerForm>(std::move(id))
      .cases([=](const Context& context) { return first_when_quick(context, corners, quick, "solved problems"); })
      .precision(Precision::at_least_fifty)
      .says(formula)
      .checked([kept = std::make_shared<KeptForCases>()]<Real R>(Findings& findings, const CornerForm& form,
                                                                 const SolvedCorner& c, const Context& context) {
        const SolvedAtCorner<R>& at_corner = kept->at(c, [&] { return solve_corner<R>(c); });
        check_regular_part(findings, at_corner, form);
        check_signs(findings, at_corner, form, c);
        // The form that is continued across c comes from the solver. Another rule checks that it satisfies the
        // equation. A quick run does this in double, because this rule costs more than the rest of the check.
        if (context.quick) {
          check_equation(findings, solve<double>(c.problem)->form());
        } else {
          check_equation(findings, at_corner.solution->form());
        }
      });
}

}  // namespace steadyslide::proofs_checks
