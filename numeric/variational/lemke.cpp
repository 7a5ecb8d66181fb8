#include "numeric/variational/lemke.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "numeric/variational/complementary_tableau.hpp"

namespace steadyslide::numeric::variational {
namespace {

using Eigen::Index;
using End = ComplementaryTableau::End;

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// A flat face touches everywhere at once; a slight curvature, the same every time, gives the cells an order.
double order(const CellMesh& mesh, std::size_t cell) {
  constexpr double slight = 1e-9;
  const double width = mesh.edges().back() - mesh.edges().front();
  const double x = (mesh.centre(cell) - mesh.edges().front()) / width - 0.4142135;
  return slight * x * x;
}

std::vector<Index> numbers(Index first, Index count) {
  std::vector<Index> result(at(count));
  std::iota(result.begin(), result.end(), first);
  return result;
}

/// The set's own solution; a few cells that the slight curvature has misled change sides.
void finish(const DiscreteProblem& problem, const std::vector<std::size_t>& cells, LemkeResult& result) {
  constexpr int most_changes = 6;
  double best = HUGE_VAL;
  CellSet contact = result.contact;
  for (int k = 0; k < most_changes; ++k) {
    const DiscreteState state = solve(*dense_system(problem, contact), problem).state;
    const double residual = natural_residual(problem, state, cells);
    if (!(residual < best)) break;
    best = residual;
    result.contact = contact;
    result.state = state;
    const std::vector<double> g = gaps(problem, state);
    for (std::size_t i : cells) contact[i] = contact[i] ? state.pressure[i] >= 0 : g[i] < 0;
    if (contact == result.contact) break;
  }
  result.reached = best <= complementary_within;
}

/// Variables: q (0..n-1), g (n..2n-1), approach, load.
ComplementaryTableau::End load_path(const DiscreteProblem& problem, const std::vector<std::size_t>& cells,
                                    int most_pivots, LemkeResult& result) {
  const CellMesh& mesh = problem.mesh();
  const auto n = static_cast<Index>(cells.size());
  Eigen::MatrixXd matrix(n + 1, n + 1);
  Eigen::VectorXd constants = Eigen::VectorXd::Zero(n + 1);
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i)
      matrix(i, j) = problem.influence().entry(cells[at(i)], cells[at(j)]) / mesh.length(cells[at(j)]);
    matrix(n, j) = 1;
    constants(j) = problem.profile()[cells[at(j)]] + order(mesh, cells[at(j)]);
  }
  matrix.col(n).setConstant(-1);
  matrix(n, n) = 0;
  std::vector<Index> left = numbers(n, n);
  std::vector<Index> right = numbers(0, n);
  right.push_back(2 * n);
  left.push_back(2 * n + 1);
  Index lowest = 0;
  constants.head(n).minCoeff(&lowest);

  ComplementaryTableau tableau(n, left, right, std::move(matrix), std::move(constants));
  tableau.exchange(n + lowest, 2 * n);
  const End end = tableau.follow(lowest, 2 * n + 1, 1, most_pivots);
  for (Index i = 0; i < n; ++i) result.contact[cells[at(i)]] = tableau.is_positive(i);
  result.pivots = tableau.pivots();
  return end;
}

/// Variables: q (0..n-1), g (n..2n-1), approach, tilt, moment.
ComplementaryTableau::End tilt_path(const DiscreteProblem& problem, const std::vector<std::size_t>& cells,
                                    int most_pivots, LemkeResult& result) {
  const CellMesh& mesh = problem.mesh();
  const auto n = static_cast<Index>(cells.size());
  const Index last = n - 1;
  const auto xi = [&](Index i) { return mesh.centre(cells[at(i)]); };
  // The last force is 1 less the others.
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 2, n + 1);
  Eigen::VectorXd constants(n + 2);
  const auto entry = [&](Index i, Index j) {
    return problem.influence().entry(cells[at(i)], cells[at(j)]) / mesh.length(cells[at(j)]);
  };
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < last; ++j) matrix(i, j) = entry(i, j) - entry(i, last);
    matrix(i, last) = -1;
    matrix(i, n) = xi(i);
    constants(i) = problem.profile()[cells[at(i)]] + order(mesh, cells[at(i)]) + entry(i, last);
  }
  for (Index j = 0; j < last; ++j) {
    matrix(n, j) = -1;
    matrix(n + 1, j) = xi(j) - xi(last);
  }
  constants(n) = 1;
  constants(n + 1) = xi(last);
  // The tilt at which a second cell touches.
  Index second = 0;
  double tilt = HUGE_VAL;
  for (Index i = 0; i < last; ++i) {
    const double until = (constants(i) - constants(last)) / (xi(last) - xi(i));
    if (until < tilt) {
      tilt = until;
      second = i;
    }
  }
  std::vector<Index> left = numbers(n, n);
  std::vector<Index> right = numbers(0, last);
  left.insert(left.end(), {last, 2 * n + 2});
  right.insert(right.end(), {2 * n, 2 * n + 1});

  ComplementaryTableau tableau(n, left, right, std::move(matrix), std::move(constants));
  tableau.exchange(n + last, 2 * n);
  tableau.exchange(n + second, 2 * n + 1);
  const End end = tableau.follow(second, 2 * n + 2, *problem.load_at(), most_pivots);
  for (Index i = 0; i < n; ++i) result.contact[cells[at(i)]] = tableau.is_positive(i);
  result.pivots = tableau.pivots();
  return end;
}

}  // namespace

double natural_residual(const DiscreteProblem& problem, const DiscreteState& state,
                        const std::vector<std::size_t>& cells) {
  const std::vector<double> g = gaps(problem, state);
  double largest = 0;
  for (std::size_t i : cells) {
    const double least = std::abs(std::min(g[i], state.pressure[i]));
    // A comparison that a NaN does not pass.
    if (!(least <= largest)) largest = least;
  }
  return largest;
}

double natural_residual(const DiscreteProblem& problem, const DiscreteState& state) {
  std::vector<std::size_t> cells(problem.size());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  return natural_residual(problem, state, cells);
}

LemkeResult lemke_among(const DiscreteProblem& problem, const std::vector<std::size_t>& cells, int most_pivots) {
  LemkeResult result;
  result.contact.assign(problem.size(), 0);
  if (cells.size() < (problem.load_at() ? 2U : 1U)) return result;
  const auto& path = problem.load_at() ? tilt_path : load_path;
  if (path(problem, cells, most_pivots, result) == End::reached) finish(problem, cells, result);
  return result;
}

LemkeResult lemke(const DiscreteProblem& problem, int most_pivots) {
  std::vector<std::size_t> cells(problem.size());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  return lemke_among(problem, cells, most_pivots);
}

}  // namespace steadyslide::numeric::variational
