#include "proofs_checks/instruments/cells/interior_point.hpp"
#include "proofs_checks/instruments/operators/moment_comparison.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::prop_07_problem_I {
namespace {

using State = DisplacementProblem::State;

constexpr double allowed = 1e-10;

/// A problem on n polynomials, contact sets to start from, and displacements, minus u, to test the inequality.
struct Case {
  DualCase dual;
  int n;
  std::vector<std::vector<char>> starts;
  std::vector<Eigen::VectorXd> directions;
};

std::string text_of(const Case& c) {
  return "s = " + to_string(c.dual.s) + ", " + std::to_string(c.n) + " nodes, " + to_string(c.dual.profile);
}

CaseList<Case> cases(const Context& context) {
  const auto make = [&](Random& random, std::size_t k) {
    const Rational s = random.between(Rational(1, 10), k % 3 == 0 ? 3 : 1) * (k % 2 == 0 ? 1 : -1);
    const Polynomial profile = random_profile(random, k % 2 == 0);
    const Rational load = random.between(Rational(1, 5), 4);
    const std::size_t n = 8 + random.below(context.quick ? 12 : 32);
    Case c{{"", s, profile, load, 0}, static_cast<int>(n), {}, {}};
    for (int start = 0; start < 3; ++start) c.starts.push_back(random_contact_set(random, n));
    for (int j = 0; j < 6; ++j) {
      c.directions.emplace_back(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n)));
      for (double& at : c.directions.back()) {
        if (j % 2 == 0 || random.below(8) == 0) at = to_real<double>(random.between(-1, 1));
      }
    }
    return c;
  };
  return random_cases(context, "prop-07-problem-I", 60, 6,
                      "random `s` of both signs, profiles and loads, 8 to 40 nodes, three random sets each", make);
}

/// The variant of problem I that interior points solve, and its inequality.
struct ProblemI {
  DisplacementFormula problem = {};
  double forces = 1;      ///< factor of the solution's forces
  double functional = 1;  ///< factor of phi in the inequality
};

/// Checks a(v - u, u) + phi(v) - phi(u) >= 0 for v = u + direction, and for the other solution as v.
void check_inequality(Findings& findings, const DisplacementProblem& problem, const State& other, const State& state,
                      const ProblemI& form, const Case& c) {
  const double scale = std::max(1.0, state.gap.maxCoeff());
  const auto compare = [&](const Eigen::VectorXd& v) {
    const double whole =
        problem.inequality(other, v) + (form.functional - 1) * (problem.phi(v) - problem.phi(-other.gap));
    findings.compare("inequality", std::max(0.0, -whole) / scale);
  };
  compare(-state.gap);
  for (const Eigen::VectorXd& direction : c.directions) compare(direction - other.gap);
}

void check(Findings& findings, const ProblemI& form, const Case& c) {
  const auto load = to_real<double>(c.dual.load);
  const DisplacementProblem problem(c.dual.s, c.n, c.dual.height(), load);
  std::vector<State> found;
  for (const std::vector<char>& start : c.starts) {
    if (const auto state = problem.by_active_sets(start)) found.push_back(*state);
  }
  auto other = DisplacementProblem(c.dual.s, c.n, c.dual.height(), load, form.problem).by_interior_points();
  if (!other || found.empty()) return findings.skip("forces");
  other->force *= form.forces;
  for (const State& state : found) findings.compare("forces", difference(state.force, other->force));
  check_inequality(findings, problem, *other, found.front(), form, c);
}

}  // namespace

Claim claim() {
  return formula_claim<Case, ProblemI>("prop-07-problem-I")
      .cases(cases)
      .precision(Precision::in_double)
      .checked(check)
      .wrong("the friction's sign reversed in `L`", [](ProblemI& form) { form.problem.inverse.friction = -1; })
      .wrong("`L` with the printed `(1+x)^{1/2}`", [](ProblemI& form) { form.problem.inverse.printed = true; })
      .wrong("twice the load", [](ProblemI& form) { form.problem.load = 2; })
      .wrong("`-psi` instead of `psi`", [](ProblemI& form) { form.problem.profile = -1; })
      .wrong("the `t_0` of `-alpha` in `phi`", [](ProblemI& form) { form.problem.other_angle = true; })
      .wrong("the inequality without `phi`", &ProblemI::functional, 0)
      .wrong("near miss: forces moved by ten times the tolerance", [](ProblemI& form) { form.forces += 10 * allowed; });
}

}  // namespace steadyslide::proofs_checks::prop_07_problem_I
