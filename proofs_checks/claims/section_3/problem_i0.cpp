// Problem I0 on cells: one solution, which tends to the continuous one. [Bal16, proposition 6]

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "numeric/variational/active_set.hpp"
#include "proofs_checks/claims/section_3/dual_problem_parts.hpp"
#include "proofs_checks/instruments/dual_study.hpp"
#include "proofs_checks/instruments/interior_point.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::variational::ActiveSetResult;
using numeric::variational::CellMesh;
using numeric::variational::CellSet;
using numeric::variational::DiscreteProblem;
using numeric::variational::DiscreteState;

struct CellsSaid {
  bool reversed = false;   ///< friction, in the Riemann-Hilbert solution
  double load = 1;         ///< factor, for interior points
  int profile = 1;         ///< factor, for interior points
  bool falling = false;    ///< a jump of s from 5 to 0 instead of a constant
  bool with_load = false;  ///< definiteness also asked of tractions with a mean, on a support of length 8
  double rate_offset = 0;
  double moved = 0;  ///< the forces by interior points
};

/// b(t, t) on zero-mean tractions: friction adds nothing and the logarithm's part is positive.
void check_form(Findings& findings, const DiscreteProblem& problem, bool with_load) {
  const Quantity friction{"b(t, t) on zero-mean tractions", {"with friction", "without"}, tolerance<double>()};
  const Eigen::MatrixXd whole = symmetric_part(problem.mesh(), problem.influence(), true);
  const Eigen::MatrixXd without = symmetric_part(problem.mesh(), problem.influence(), false);
  const Eigen::MatrixXd form = on_zero_mean(whole);
  const Eigen::MatrixXd plain = on_zero_mean(without);
  findings.compare(friction, (form - plain).norm() / plain.norm());
  // A support of length 8 instead of 1 takes log(8)/pi off each entry.
  const Eigen::MatrixXd asked = with_load ? Eigen::MatrixXd(without.array() - std::log(8.0) / std::numbers::pi) : form;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(asked, Eigen::EigenvaluesOnly);
  findings.require(solver.eigenvalues().minCoeff() > 0, "b(t, t) is not positive");
}

/// sum g_i (p_hat_i - p_i) h_i >= 0 for random pressures p_hat >= 0 of the same load.
void check_inequality(Findings& findings, Random& random, const DiscreteProblem& problem, const DiscreteState& state) {
  const Quantity inequality{
      "b(t, t_hat-t) - <<psi, t_hat-t>> below zero", {"random t_hat in K_0'", "none"}, 100 * tolerance<double>()};
  const std::vector<double> g = gaps(problem, state);
  const std::size_t n = problem.size();
  double scale = 1;
  for (const double gap : g) scale = std::max(scale, std::abs(gap));
  for (int k = 0; k < 4; ++k) {
    std::vector<double> force(n);
    double sum = 0;
    for (double& value : force) {
      value = k % 2 == 0 || random.below(4) == 0 ? numeric::to_real<double>(random.between(0, 1)) : 0;
      sum += value;
    }
    if (sum == 0) continue;
    double value = 0;
    for (std::size_t i = 0; i < n; ++i) value += g[i] * (force[i] / sum - state.pressure[i] * problem.mesh().length(i));
    findings.compare(inequality, std::max(0.0, -value) / scale);
  }
}

void check_uniqueness(Findings& findings, const Context& context, const CellsSaid& said) {
  const Quantity forces{
      "forces on the cells", {"active sets from random sets", "interior points"}, tolerance<double>(), 0.7};
  constexpr std::array<Cells, 3> kinds{Cells::equal, Cells::unequal, Cells::alternating};
  Random random(context.seed, "prop-06-problem-I0");
  const std::size_t count = context.quick ? 8 : 80;
  for (std::size_t k = 0; k < count; ++k) {
    CellFrictionSteps steps{{random.between(0, k % 3 == 0 ? 3 : 1) * (k % 2 == 0 ? 1 : -1)}, {}};
    Polynomial profile = random_profile(random, k % 2 == 0);
    Rational load = random.between(Rational(1, 5), 4);
    std::size_t cells = 16 + random.below(16);
    if (said.falling) {
      // Three solutions: cell_solutions.cpp.
      steps = {{5, 0}, {0}};
      profile = Polynomial({0, 0, 1});
      load = Rational(1, 2);
      cells = 8;
    }
    const ContactProblem problem = cell_problem(steps, profile, load);
    const CellMesh mesh = random_cells(random, problem, said.falling ? Cells::equal : kinds[k % 3], cells);
    const DiscreteProblem discrete(problem, mesh);
    findings.begin_case("problem " + std::to_string(k) + ", " + text_of(steps));
    if (!said.falling) check_form(findings, discrete, said.with_load);
    const Polynomial factor = Polynomial::constant(said.profile);
    const Rational other_load = load * Rational(static_cast<long>(said.load));
    auto other = forces_by_interior_points(DiscreteProblem(cell_problem(steps, factor * profile, other_load), mesh));
    if (other) *other *= 1 + said.moved;
    std::size_t found = 0;
    for (unsigned start = 0; start < (said.falling ? 255U : 3U); ++start) {
      CellSet set(cells, 0);
      for (std::size_t i = 0; i < cells; ++i) {
        set[i] = static_cast<char>(said.falling ? (start + 1) >> i & 1U : random.below(2));
      }
      if (!said.falling) set[random.below(cells)] = 1;
      const ActiveSetResult result = active_set(discrete, set, {std::vector<double>(cells, 0)}, {});
      if (result.outcome != ActiveSetResult::Outcome::solved || !other) continue;
      findings.compare(forces, difference(forces_of(discrete, result.state), *other));
      check_inequality(findings, random, discrete, result.state);
      ++found;
    }
    if (found == 0) findings.skip(forces);
  }
}

/// Cells are solved once for a claim and its controls.
class Convergence {
 public:
  struct Said {
    Moments exact;
    std::vector<Level> levels;
  };
  const Said& of(std::size_t k, bool quick, bool reversed) {
    const auto key = std::tuple(k, quick, reversed);
    const auto found = studies_.find(key);
    if (found != studies_.end()) return found->second;
    const DualCase c = dual_cases()[k];
    Said said{riemann_hilbert_moments(c.problem(reversed ? -1 : 1)), {}};
    const std::vector<int> first =
        quick ? std::vector<int>{32, 64, 128} : std::vector<int>{32, 64, 128, 256, 512, 1024};
    said.levels = levels_of(first, 7, said.exact, numeric::to_real<double>(c.load), [&](int n) -> const Moments& {
      Moments& moments = cells_[{k, n}];
      if (moments.empty()) moments = cell_moments(c.problem(), static_cast<std::size_t>(n));
      return moments;
    });
    return studies_.emplace(key, std::move(said)).first->second;
  }

 private:
  std::map<std::tuple<std::size_t, bool, bool>, Said> studies_;
  std::map<std::pair<std::size_t, int>, Moments> cells_;
};

void check_convergence(Findings& findings, Convergence& convergence, const Context& context, const CellsSaid& said) {
  const std::vector<DualCase> cases = dual_cases();
  for (std::size_t k = 0; k < (context.quick ? 2 : cases.size()); ++k) {
    findings.begin_case(cases[k].name);
    const auto& study = convergence.of(k, context.quick, said.reversed);
    const Rate rate = fitted_rate(study.levels);
    findings.measure({"t_n on N cells to the Riemann-Hilbert solution, " + cases[k].name, rate.value, rate.error_bar,
                      cases[k].cells_rate + said.rate_offset, context.quick ? 0.3 : 0.15,
                      "error " + short_text(study.levels.back().error) + " with " +
                          std::to_string(std::lround(study.levels.back().cells)) + " cells"});
  }
}

}  // namespace

Claim problem_i0_claim() {
  using S = CellsSaid;
  const auto check = [convergence = std::make_shared<Convergence>()](const Context& context, const S& said) {
    return gather([&] {
      Findings findings;
      check_uniqueness(findings, context, said);
      check_convergence(findings, *convergence, context, said);
      return findings.evidence("random s of both signs, profiles, loads and meshes, seed " +
                               std::to_string(context.seed));
    });
  };
  return make_claim(
      claim_text("prop-06-problem-I0"), check, S(),
      std::vector<Wrong<S>>{
          {"the friction reversed in the Riemann-Hilbert solution", changed<S>([](S& said) { said.reversed = true; })},
          {"twice the load", changed<S>([](S& said) { said.load = 2; })},
          {"-psi instead of psi", changed<S>([](S& said) { said.profile = -1; })},
          {"a falling jump of the friction: three solutions", changed<S>([](S& said) { said.falling = true; })},
          {"positive also with a mean, on any support", changed<S>([](S& said) { said.with_load = true; })},
          {"one order more", changed<S>([](S& said) { said.rate_offset = 1; })},
          {"near miss: forces moved by ten times the tolerance",
           changed<S>([](S& said) { said.moved = near_miss<double>(); })}});
}

}  // namespace steadyslide::proofs_checks
