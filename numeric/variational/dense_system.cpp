#include <Eigen/LU>

#include "numeric/variational/discrete_problem.hpp"

namespace steadyslide::numeric::variational {

SystemSolution solve_densely(const DiscreteProblem& problem, const CellSet& contact) {
  const CellMesh& mesh = problem.mesh();
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < contact.size(); ++i) {
    if (contact[i]) cells.push_back(i);
  }
  const auto n = static_cast<Eigen::Index>(cells.size());
  const Eigen::Index loads = problem.load_at() ? 2 : 1;
  // Unknowns: pressures, approach, tilt. Equations: g = 0 on the cells, load, moment.
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + loads, n + loads);
  Eigen::VectorXd right(n + loads);
  for (Eigen::Index j = 0; j < n; ++j) {
    const std::size_t cell = cells[static_cast<std::size_t>(j)];
    for (Eigen::Index i = 0; i < n; ++i) {
      matrix(i, j) = problem.influence().entry(cells[static_cast<std::size_t>(i)], cell);
    }
    matrix(j, n) = -1;
    matrix(n, j) = mesh.length(cell);
    if (loads == 2) {
      matrix(j, n + 1) = mesh.centre(cell);
      matrix(n + 1, j) = mesh.length(cell) * mesh.centre(cell);
    }
    right(j) = -problem.profile()[cell];
  }
  right(n) = 1;
  if (loads == 2) right(n + 1) = *problem.load_at();

  const Eigen::VectorXd found = matrix.partialPivLu().solve(right);
  SystemSolution result;
  result.residual = n == 0 ? 0 : (matrix.topRows(n) * found - right.head(n)).cwiseAbs().maxCoeff();
  result.state.pressure.assign(contact.size(), 0);
  for (Eigen::Index j = 0; j < n; ++j) result.state.pressure[cells[static_cast<std::size_t>(j)]] = found(j);
  result.state.approach = found(n);
  if (loads == 2) result.state.tilt = found(n + 1);
  return result;
}

}  // namespace steadyslide::numeric::variational
