#include <algorithm>
#include <numeric>

#include "numeric/variational/complementary_tableau.hpp"
#include "numeric/variational/lemke.hpp"

namespace steadyslide::numeric::variational {
namespace {

using Eigen::Index;
using End = ComplementaryTableau::End;

/// The contested cells' gaps as functions of their forces, the certain contact moving along: gaps + matrix q.
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
  for (Index i = 0; i < n; ++i) result.gaps(i) = g[contested[static_cast<std::size_t>(i)]];

  std::vector<double> rhs(problem.size());
  std::vector<double> push(problem.size());
  for (Index j = 0; j < n; ++j) {
    // A force 1 on one contested cell, taken off the others.
    const std::size_t cell = contested[static_cast<std::size_t>(j)];
    const double h = mesh.length(cell);
    for (std::size_t i = 0; i < rhs.size(); ++i) rhs[i] = -problem.galerkin_operator().entry(i, cell) / h;
    DiscreteState answer = system.solve(rhs, {-1, -mesh.centre(cell)}).state;
    answer.pressure[cell] = 1 / h;
    problem.galerkin_operator().multiply(answer.pressure, push);
    for (Index i = 0; i < n; ++i) {
      const std::size_t other = contested[static_cast<std::size_t>(i)];
      result.matrix(i, j) = push[other] + answer.tilt * mesh.centre(other) - answer.approach;
    }
  }
  return result;
}

}  // namespace

LemkeResult lemke_on(const DiscreteProblem& problem, const CellSet& contact, const std::vector<std::size_t>& contested,
                     const BorderedSystemMaker& bordered_system, int most_pivots) {
  LemkeResult result;
  result.contact = contact;
  for (std::size_t cell : contested) result.contact[cell] = 0;
  const auto certain = std::count_if(result.contact.begin(), result.contact.end(), [](char c) { return c != 0; });
  if (certain < (problem.load_at() ? 2 : 1)) {
    CellSet possible = result.contact;
    for (std::size_t cell : contested) possible[cell] = 1;
    std::vector<std::size_t> cells;
    for (std::size_t i = 0; i < possible.size(); ++i) {
      if (possible[i]) cells.push_back(i);
    }
    return lemke_among(problem, cells, most_pivots);
  }
  const std::unique_ptr<BorderedSystem> system = bordered_system(problem, result.contact);
  result.state = solve(*system, problem).state;
  const SchurComplement schur = schur_complement(problem, contested, *system, result.state);

  // Variables: q (0..n-1), g (n..2n-1), and the artificial one, less than 0 until the path's end.
  const auto n = static_cast<Index>(contested.size());
  Index lowest = 0;
  if (n > 0 && schur.gaps.minCoeff(&lowest) < 0) {
    Eigen::MatrixXd matrix(n, n + 1);
    matrix << schur.matrix, Eigen::VectorXd::Constant(n, -1);
    std::vector<Index> left(contested.size());
    std::iota(left.begin(), left.end(), n);
    std::vector<Index> right(contested.size() + 1, 2 * n);
    std::iota(right.begin(), right.end() - 1, 0);
    ComplementaryTableau tableau(n, left, right, std::move(matrix), schur.gaps);
    tableau.exchange(n + lowest, 2 * n);
    const End end = tableau.follow(lowest, 2 * n, 0, most_pivots);
    result.pivots = tableau.pivots();
    if (end != End::reached) return result;
    for (Index i = 0; i < n; ++i) result.contact[contested[static_cast<std::size_t>(i)]] = tableau.is_positive(i);
    result.state = solve(*bordered_system(problem, result.contact), problem).state;
  }
  result.reached = natural_residual(problem, result.state, contested) <= complementary_within;
  return result;
}

}  // namespace steadyslide::numeric::variational
