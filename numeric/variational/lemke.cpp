#include "numeric/variational/lemke.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "numeric/number/complementary_tableau.hpp"

namespace steadyslide::numeric::variational {
namespace {

using Eigen::Index;

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Returns the height of a cell, perturbed to general position.
double height(const DiscreteProblem& problem, std::size_t cell) {
  const CellMesh& mesh = problem.mesh();
  return problem.profile()[cell] + slight_curve(mesh.centre(cell), mesh.edges().front(), mesh.edges().back(), 1e-9);
}

/// Returns the gap in cell i due to a force 1 on cell j.
double by_force(const DiscreteProblem& problem, std::size_t i, std::size_t j) {
  return problem.galerkin_operator().entry(i, j) / problem.mesh().length(j);
}

template <class Number>
std::vector<Number> numbers(Number first, Number count) {
  std::vector<Number> result(static_cast<std::size_t>(count));
  std::iota(result.begin(), result.end(), first);
  return result;
}

/// Computes the solution of the contact set. A few cells for which the slight curvature was misleading change sides.
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

/// Follows the path from the tableau's current point until the variable `measured` has its target value.
PivotPath followed(ComplementaryTableau& tableau, std::size_t pairs, Index entering, Index measured, double target,
                   int most_pivots) {
  const bool reached = tableau.follow(entering, measured, target, most_pivots) == ComplementaryTableau::End::reached;
  PivotPath path{CellSet(pairs), reached, tableau.pivots()};
  for (std::size_t i = 0; i < pairs; ++i) path.contact[i] = tableau.is_positive(static_cast<Index>(i));
  return path;
}

/// Returns the path of loads, which starts from zero load.
PivotPath loading_path(const DiscreteProblem& problem, const std::vector<std::size_t>& cells, int most_pivots) {
  const auto n = static_cast<Index>(cells.size());
  Eigen::MatrixXd influence(n, n);
  Eigen::VectorXd heights(n);
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) influence(i, j) = by_force(problem, cells[at(i)], cells[at(j)]);
    heights(j) = height(problem, cells[at(j)]);
  }
  Index lowest = 0;
  heights.minCoeff(&lowest);
  return load_path(influence, heights, {at(lowest)}, std::nullopt, most_pivots);
}

enum class From { left, right };

/// Returns the path of tilts, which starts with all load on the end cell of one side. Variables: q (0..n-1), g
/// (n..2n-1), approach, tilt (minus the tilt if it starts from the left, so that it grows from -infinity), moment.
PivotPath rolling_path(const DiscreteProblem& problem, const std::vector<std::size_t>& cells, From from,
                       int most_pivots) {
  const CellMesh& mesh = problem.mesh();
  const auto n = static_cast<Index>(cells.size());
  const Index last = from == From::right ? n - 1 : 0;
  const double sense = from == From::right ? 1 : -1;
  const auto xi = [&](Index i) { return mesh.centre(cells[at(i)]); };
  const auto place = [&](Index i) { return problem.place(cells[at(i)]); };
  const auto entry = [&](Index i, Index j) { return by_force(problem, cells[at(i)], cells[at(j)]); };
  // The force on the end cell is 1 minus the others.
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 2, n + 1);
  Eigen::VectorXd constants(n + 2);
  std::vector<Index> right;
  for (Index j = 0; j < n; ++j) {
    constants(j) = height(problem, cells[at(j)]) + entry(j, last);
    if (j == last) continue;
    const auto column = static_cast<Index>(right.size());
    for (Index i = 0; i < n; ++i) matrix(i, column) = entry(i, j) - entry(i, last);
    matrix(n, column) = -1;
    matrix(n + 1, column) = xi(j) - xi(last);
    right.push_back(j);
  }
  for (Index i = 0; i < n; ++i) {
    matrix(i, n - 1) = -1;
    matrix(i, n) = sense * place(i);
  }
  constants(n) = 1;
  constants(n + 1) = xi(last);
  right.insert(right.end(), {2 * n, 2 * n + 1});
  std::vector<Index> left = numbers<Index>(n, n);
  left.insert(left.end(), {last, 2 * n + 2});

  // The tilt at which a second cell touches.
  Index second = last;
  double tilt = HUGE_VAL;
  for (Index i = 0; i < n; ++i) {
    if (i == last) continue;
    const double until = (constants(i) - constants(last)) / std::abs(place(last) - place(i));
    if (until < tilt) {
      tilt = until;
      second = i;
    }
  }
  if (!problem.load_at() && tilt >= 0) {
    PivotPath path{CellSet(cells.size()), true, 0};
    path.contact[at(last)] = 1;
    return path;
  }
  ComplementaryTableau tableau(n, left, right, std::move(matrix), std::move(constants));
  tableau.exchange(n + last, 2 * n);
  tableau.exchange(n + second, 2 * n + 1);
  return problem.load_at() ? followed(tableau, cells.size(), second, 2 * n + 2, *problem.load_at(), most_pivots)
                           : followed(tableau, cells.size(), second, 2 * n + 1, 0, most_pivots);
}

/// Sets the cells in contact at the end of a path of these cells.
void take(const PivotPath& path, const std::vector<std::size_t>& cells, LemkeResult& result) {
  for (std::size_t i = 0; i < cells.size(); ++i) result.contact[cells[i]] = path.contact[i];
}

/// The gaps of the contested cells as functions of their forces, with equilibrium on the certain contact: gaps + matrix
/// q.
struct SchurComplement {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd gaps;
};

SchurComplement schur_complement(const DiscreteProblem& problem, const std::vector<std::size_t>& contested,
                                 BorderedSystem& system, const DiscreteState& state) {
  const CellMesh& mesh = problem.mesh();
  const auto n = static_cast<Index>(contested.size());
  SchurComplement result{Eigen::MatrixXd(n, n), Eigen::VectorXd(n)};
  const std::vector<double> g = gaps(problem, state);
  for (Index i = 0; i < n; ++i) result.gaps(i) = g[contested[at(i)]];

  std::vector<double> rhs(problem.size());
  std::vector<double> push(problem.size());
  for (Index j = 0; j < n; ++j) {
    // A force 1 on one contested cell, subtracted from the others.
    const std::size_t cell = contested[at(j)];
    const double h = mesh.length(cell);
    for (std::size_t i = 0; i < rhs.size(); ++i) rhs[i] = -problem.galerkin_operator().entry(i, cell) / h;
    DiscreteState answer = system.solve(rhs, {-1, -mesh.centre(cell)}).state;
    answer.pressure[cell] = 1 / h;
    problem.galerkin_operator().multiply(answer.pressure, push);
    for (Index i = 0; i < n; ++i) {
      const std::size_t other = contested[at(i)];
      result.matrix(i, j) = push[other] + answer.tilt * problem.place(other) - answer.approach;
    }
  }
  return result;
}

}  // namespace

double slight_curve(double x, double from, double to, double size) {
  const double part = (x - from) / (to - from) - 0.4142135;
  return size * part * part;
}

PivotPath load_path(const Eigen::MatrixXd& influence, const Eigen::VectorXd& heights,
                    const std::vector<std::size_t>& first, const std::optional<Levers>& levers, int most_pivots) {
  // Variables: forces (0..n-1), gaps (n..2n-1), approach, the load, the tilt over the whole width and the moment about
  // the load, which always stays on the right: it is zero.
  const Index n = heights.size();
  const Index approach = 2 * n, load = approach + 1, tilt = approach + 2, moment = approach + 3;
  const Index rest = levers ? 2 : 1;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + rest, n + rest);
  Eigen::VectorXd constants = Eigen::VectorXd::Zero(n + rest);
  matrix.topLeftCorner(n, n) = influence;
  matrix.row(n).head(n).setOnes();
  matrix.col(n).head(n).setConstant(-1);
  constants.head(n) = heights;
  std::vector<Index> left = numbers<Index>(n, n);
  std::vector<Index> right = numbers<Index>(0, n);
  left.push_back(load);
  right.push_back(approach);
  if (levers) {
    matrix.row(n + 1).head(n) = levers->arm / levers->width;
    matrix.col(n + 1).head(n) = levers->point / levers->width;
    left.push_back(moment);
    right.push_back(tilt);
  }
  ComplementaryTableau tableau(n, left, right, std::move(matrix), std::move(constants));

  auto growing = static_cast<Index>(first.front());
  tableau.exchange(n + growing, approach);
  if (levers) {
    // The force farther from the load is determined by the other one.
    auto held = static_cast<Index>(first.back());
    tableau.exchange(n + held, tilt);
    if (std::abs(levers->arm(growing)) > std::abs(levers->arm(held))) std::swap(growing, held);
    tableau.exchange(moment, held);
  }
  return followed(tableau, at(n), growing, load, 1, most_pivots);
}

double natural_residual(const DiscreteProblem& problem, const DiscreteState& state,
                        const std::vector<std::size_t>& cells) {
  const std::vector<double> g = gaps(problem, state);
  double largest = 0;
  for (std::size_t i : cells) {
    const double least = std::abs(std::min(g[i], state.pressure[i]));
    // The comparison is false for NaN.
    if (!(least <= largest)) largest = least;
  }
  return largest;
}

double natural_residual(const DiscreteProblem& problem, const DiscreteState& state) {
  return natural_residual(problem, state, numbers<std::size_t>(0, problem.size()));
}

LemkeResult lemke_among(const DiscreteProblem& problem, const std::vector<std::size_t>& cells, int most_pivots) {
  LemkeResult result;
  // This is sufficient for most problems. If not, another path may be much shorter.
  int allowed = std::min(most_pivots, 4 * static_cast<int>(cells.size()) + 16);
  while (cells.size() >= (problem.load_at() ? 2U : 1U)) {
    for (const auto& path : {std::optional<From>(), std::optional(From::right), std::optional(From::left)}) {
      if (!path && problem.load_at()) continue;
      if (path && cells.size() < 2) continue;
      result.contact.assign(problem.size(), 0);
      const int left = std::min(allowed, most_pivots - result.pivots);
      const PivotPath way = path ? rolling_path(problem, cells, *path, left) : loading_path(problem, cells, left);
      take(way, cells, result);
      result.pivots += way.pivots;
      if (way.reached) finish(problem, cells, result);
      if (result.reached) return result;
    }
    if (result.pivots >= most_pivots || allowed >= most_pivots) break;
    allowed *= 4;
  }
  result.contact.assign(problem.size(), 0);
  return result;
}

LemkeResult lemke(const DiscreteProblem& problem, int most_pivots) {
  return lemke_among(problem, numbers<std::size_t>(0, problem.size()), most_pivots);
}

LemkeResult lemke_on(const DiscreteProblem& problem, const CellSet& contact, const std::vector<std::size_t>& contested,
                     const BorderedSystemMaker& bordered_system, int most_pivots) {
  LemkeResult result;
  result.contact = contact;
  for (std::size_t cell : contested) result.contact[cell] = 0;
  const auto certain = std::count_if(result.contact.begin(), result.contact.end(), [](char c) { return c != 0; });
  if (certain < (problem.load_at() ? 2 : 1)) {
    CellSet possible = result.contact;
    for (std::size_t cell : contested) possible[cell] = 1;
    return lemke_among(problem, cells_of(possible), most_pivots);
  }
  const std::unique_ptr<BorderedSystem> system = bordered_system(problem, result.contact);
  result.state = solve(*system, problem).state;
  const SchurComplement schur = schur_complement(problem, contested, *system, result.state);

  // Variables: q (0..n-1), g (n..2n-1), and the artificial variable, which is negative until the end of the path.
  const auto n = static_cast<Index>(contested.size());
  Index lowest = 0;
  if (n > 0 && schur.gaps.minCoeff(&lowest) < 0) {
    Eigen::MatrixXd matrix(n, n + 1);
    matrix << schur.matrix, Eigen::VectorXd::Constant(n, -1);
    std::vector<Index> right = numbers<Index>(0, n);
    right.push_back(2 * n);
    ComplementaryTableau tableau(n, numbers<Index>(n, n), right, std::move(matrix), schur.gaps);
    tableau.exchange(n + lowest, 2 * n);
    const PivotPath path = followed(tableau, contested.size(), lowest, 2 * n, 0, most_pivots);
    result.pivots = path.pivots;
    if (!path.reached) return result;
    take(path, contested, result);
    result.state = solve(*bordered_system(problem, result.contact), problem).state;
  }
  result.reached = natural_residual(problem, result.state, contested) <= complementary_within;
  return result;
}

}  // namespace steadyslide::numeric::variational
