#include <numbers>
#include <variant>

#include "proofs_checks/instruments/cells/dense_algebra.hpp"
#include "proofs_checks/instruments/cells/interior_point.hpp"
#include "proofs_checks/instruments/operators/moment_comparison.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::prop_06_problem_I0 {
namespace {

/// A problem on cells, contact sets to start from, and forces with any sum to test the inequality.
struct OnCells {
  ProblemOnCells on_cells;
  std::vector<CellSet> starts;
  std::vector<std::vector<double>> forces = {};
};
struct Case {
  std::string name;
  std::variant<OnCells, DualCase> data;
};

CaseList<Case> cases(const Context& context) {
  constexpr std::array<Cells, 3> kinds{Cells::equal, Cells::unequal, Cells::alternating};
  Random random(context.seed, "prop-06-problem-I0");
  CaseList<Case> list{{}, "random `s` of both signs, profiles, loads and meshes, seed " + std::to_string(context.seed)};
  for (std::size_t k = 0; k < (context.quick ? 8 : 80); ++k) {
    const CellFrictionSteps steps{{random.between(0, k % 3 == 0 ? 3 : 1) * (k % 2 == 0 ? 1 : -1)}, {}};
    const Polynomial profile = random_profile(random, k % 2 == 0);
    const Rational load = random.between(Rational(1, 5), 4);
    const std::size_t cells = 16 + random.below(16);
    const ContactProblem problem = cell_problem(steps, profile, load);
    OnCells c{{problem, random_cells(random, problem, kinds[k % 3], cells)}, {}};
    for (int start = 0; start < 3; ++start) {
      c.starts.emplace_back(cells, 0);
      for (char& contact : c.starts.back()) contact = static_cast<char>(random.below(2));
      c.starts.back()[random.below(cells)] = 1;
    }
    for (int j = 0; j < 4; ++j) {
      c.forces.emplace_back(cells, 0);
      for (double& force : c.forces.back()) {
        if (j % 2 == 0 || random.below(4) == 0) force = to_real<double>(random.between(0, 1));
      }
    }
    list.cases.push_back({"problem " + std::to_string(k) + ", " + text_of(steps), std::move(c)});
  }
  for (const DualCase& dual : dual_cases(context)) list.cases.push_back({dual.name, dual});
  return list;
}

/// The statement of the proposition. A problem on cells has one solution, and interior points find it. For a problem of
/// dual_cases() the solutions on cells converge to the Riemann-Hilbert solution.
struct OneSolution {
  std::optional<OnCells> unique = std::nullopt;
  std::optional<ContactProblem> interior = std::nullopt;
  double forces = 1;   ///< factor of the forces by interior points
  double support = 0;  ///< if positive, b must also be positive with a mean on a support of this length
  int friction = 1;    ///< sign of the friction in the Riemann-Hilbert solution
  double rate = 0;
};

OneSolution one_solution(const Case& c) {
  if (const auto* cells = std::get_if<OnCells>(&c.data)) return {.unique = *cells, .interior = cells->on_cells.problem};
  return {.rate = std::get<DualCase>(c.data).cells_rate};
}

/// Checks b(t, t) on tractions of zero mean: friction adds nothing, and the logarithmic part is positive.
void check_form(Findings& findings, const DiscreteProblem& problem, double support) {
  const Eigen::MatrixXd without = symmetric_part(problem.mesh(), problem.galerkin_operator(), false);
  const Eigen::MatrixXd form = on_zero_mean(symmetric_part(problem.mesh(), problem.galerkin_operator(), true));
  const Eigen::MatrixXd plain = on_zero_mean(without);
  findings.compare("friction", (form - plain).norm() / plain.norm());
  // For a support of another length than 1, the logarithm of the length over pi is subtracted from each entry.
  const Eigen::MatrixXd asked =
      support > 0 ? Eigen::MatrixXd(without.array() - std::log(support) / std::numbers::pi) : form;
  findings.require(eigenvalues(asked).minCoeff() > 0, "b(t, t) is not positive");
}

/// Checks sum g_i (p_hat_i - p_i) h_i >= 0 for random pressures p_hat >= 0 with the same load.
void check_inequality(Findings& findings, const OnCells& c, const DiscreteProblem& problem,
                      const DiscreteState& state) {
  const std::vector<double> g = gaps(problem, state);
  double scale = 1;
  for (const double gap : g) scale = std::max(scale, std::abs(gap));
  for (const std::vector<double>& force : c.forces) {
    double sum = 0;
    for (const double value : force) sum += value;
    if (sum == 0) continue;
    double value = 0;
    for (std::size_t i = 0; i < g.size(); ++i) {
      value += g[i] * (force[i] / sum - state.pressure[i] * problem.mesh().length(i));
    }
    findings.compare("inequality", std::max(0.0, -value) / scale);
  }
}

void check_uniqueness(Findings& findings, const OneSolution& said) {
  const OnCells& c = *said.unique;
  const DiscreteProblem discrete(c.on_cells.problem, c.on_cells.mesh);
  auto other = forces_by_interior_points(DiscreteProblem(*said.interior, c.on_cells.mesh));
  if (other) *other *= said.forces;
  const std::vector<DiscreteState> found = solutions_from(discrete, c.starts);
  if (found.empty() || !other) findings.skip("forces");
  for (std::size_t k = 0; k < found.size() && other; ++k) {
    findings.compare("forces", difference(forces_of(discrete, found[k]), *other));
    check_inequality(findings, c, discrete, found[k]);
  }
  check_form(findings, discrete, said.support);
}

void check_convergence(Findings& findings, KnownMoments& known, const OneSolution& said, const DualCase& c,
                       bool quick) {
  const std::vector<int> first = quick ? std::vector<int>{32, 64, 128} : std::vector<int>{32, 64, 128, 256, 512, 1024};
  const Moments exact = riemann_hilbert_moments(c.problem(said.friction));
  const auto cells = [&](int n) -> const Moments& { return known.cells(c, n); };
  const std::vector<Level> levels =
      levels_of(first, 7, to_real<double>(c.load), cells, [&](int) -> const Moments& { return exact; });
  const Rate rate = fitted_rate(levels);
  findings.measure({"`t_n` on `N` cells to the Riemann-Hilbert solution, " + c.name, rate.value, rate.error_bar,
                    said.rate, quick ? 0.3 : 0.15,
                    "error " + short_text(levels.back().error) + " with " +
                        std::to_string(std::lround(levels.back().cells)) + " cells"});
}

}  // namespace

Claim claim() {
  const auto of_cells = [](auto change) {
    return [change](OneSolution& said) {
      if (said.unique) change(said);
    };
  };
  const auto interior = [&](Rational load, Rational profile) {
    return of_cells([load, profile](OneSolution& said) {
      const ContactProblem& p = said.unique->on_cells.problem;
      said.interior = p.with_load(load * p.load()).with_indenter(p.indenter().scaled(profile));
    });
  };
  return formula_claim<Case, OneSolution>("prop-06-problem-I0")
      .cases(cases)
      .precision(Precision::in_double)
      .says(one_solution)
      .checked([known = std::make_shared<KnownMoments>()]<Real R>(Findings& findings, const OneSolution& said,
                                                                  const Case& c, const Context& context) {
        if (said.unique) return check_uniqueness(findings, said);
        check_convergence(findings, *known, said, std::get<DualCase>(c.data), context.quick);
      })
      .wrong("the friction reversed in the Riemann-Hilbert solution", &OneSolution::friction, -1)
      .wrong("twice the load", interior(2, 1))
      .wrong("`-psi` instead of `psi`", interior(1, -1))
      .wrong("a falling jump of the friction: three solutions", of_cells([](OneSolution& said) {
               said.unique = OnCells{problem_with_three_solutions(), all_contact_sets(8)};
               said.interior = said.unique->on_cells.problem;
             }))
      .wrong("positive also with a mean, on any support", &OneSolution::support, 8)
      .wrong("one order more", [](OneSolution& said) { said.rate += 1; })
      .near_miss("forces", [](OneSolution& said, const Number& step) { said.forces += static_cast<double>(step); });
}

}  // namespace steadyslide::proofs_checks::prop_06_problem_I0
