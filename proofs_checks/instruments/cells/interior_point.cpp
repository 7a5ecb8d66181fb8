#include "proofs_checks/instruments/cells/interior_point.hpp"

#include <algorithm>
#include <cmath>

#include "proofs_checks/instruments/cells/dense_algebra.hpp"

namespace steadyslide::proofs_checks {

using numeric::variational::ActiveSetResult;

namespace {

/// Returns the longest step, at most 1, that keeps x positive.
double longest_step(const Eigen::VectorXd& x, const Eigen::VectorXd& dx) {
  constexpr double share = 0.99;
  double step = 1;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (dx(i) < 0) step = std::min(step, -share * x(i) / dx(i));
  }
  return step;
}

}  // namespace

std::optional<ComplementaryPair> by_interior_points(const Eigen::MatrixXd& m, const Eigen::VectorXd& r,
                                                    std::optional<double> total) {
  constexpr int most_steps = 300;
  constexpr double towards_zero = 0.1;  // the target of a step, as a part of the mean product
  // The mean product, over the scale, at which the iteration ends. An x_i or y_i of the size of its square root is
  // rounding beside the others.
  constexpr double nothing = 1e-28;
  const Eigen::Index n = r.size();
  const Eigen::Index size = n + (total ? 1 : 0);
  const double scale = 1 + r.cwiseAbs().maxCoeff();
  Eigen::VectorXd x = Eigen::VectorXd::Constant(n, total.value_or(static_cast<double>(n)) / static_cast<double>(n));
  Eigen::VectorXd y = Eigen::VectorXd::Constant(n, scale);
  double c = 0;
  for (int k = 0; k < most_steps; ++k) {
    const double mean = x.dot(y) / static_cast<double>(n);
    const Eigen::VectorXd missing = y - m * x - r + Eigen::VectorXd::Constant(n, c);
    if (!std::isfinite(mean)) return std::nullopt;
    if (mean < nothing * scale && missing.cwiseAbs().maxCoeff() < 1e-12 * scale) return ComplementaryPair{x, y};
    // M dx - dc - dy = missing,   y dx + x dy = aim - x y,   sum dx = total - sum x
    const Eigen::VectorXd wanted = towards_zero * mean * x.cwiseInverse() - y;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd right(size);
    matrix.topLeftCorner(n, n) = m;
    matrix.diagonal().head(n) += y.cwiseQuotient(x);
    right.head(n) = missing + wanted;
    if (total) {
      matrix.col(n).head(n).setConstant(-1);
      matrix.row(n).head(n).setConstant(1);
      right(n) = *total - x.sum();
    }
    const Eigen::VectorXd step = linear_solution(matrix, right);
    const Eigen::VectorXd dx = step.head(n);
    const Eigen::VectorXd dy = wanted - y.cwiseQuotient(x).cwiseProduct(dx);
    const double length = std::min(longest_step(x, dx), longest_step(y, dy));
    x += length * dx;
    y += length * dy;
    if (total) c += length * step(n);
  }
  return std::nullopt;
}

std::vector<DiscreteState> solutions_from(const DiscreteProblem& problem, const std::vector<CellSet>& starts) {
  std::vector<DiscreteState> result;
  for (const CellSet& start : starts) {
    const ActiveSetResult found = active_set(problem, start, {std::vector<double>(problem.size(), 0)}, {});
    if (found.outcome == ActiveSetResult::Outcome::solved) result.push_back(found.state);
  }
  return result;
}

ProblemOnCells problem_with_three_solutions() {
  const ContactProblem problem = cell_problem({{5, 0}, {0}}, Polynomial({0, 0, 1}), Rational(1, 2));
  return {problem, CellMesh(problem, 8)};
}

std::vector<CellSet> all_contact_sets(std::size_t cells) {
  std::vector<CellSet> sets;
  for (unsigned bits = 1; bits < 1U << cells; ++bits) {
    sets.emplace_back(cells, 0);
    for (std::size_t i = 0; i < cells; ++i) sets.back()[i] = static_cast<char>(bits >> i & 1U);
  }
  return sets;
}

CellSet random_contact_set(Random& random, std::size_t cells) {
  CellSet set(cells, 0);
  for (char& cell : set) cell = random.below(2) == 0;
  set[random.below(cells)] = 1;
  return set;
}

Eigen::VectorXd forces_of(const DiscreteProblem& problem, const DiscreteState& state) {
  return vector_of(problem.size(), [&](std::size_t i) { return state.pressure[i] * problem.mesh().length(i); });
}

std::optional<Eigen::VectorXd> forces_by_interior_points(const DiscreteProblem& problem) {
  const Eigen::VectorXd profile = vector_of(problem.size(), [&](std::size_t i) { return problem.profile()[i]; });
  const auto found = by_interior_points(gap_of_forces(problem.galerkin_operator(), problem.mesh()), profile, 1);
  return found ? std::optional(found->x) : std::nullopt;
}

double difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / a.cwiseAbs().maxCoeff();
}

}  // namespace steadyslide::proofs_checks
