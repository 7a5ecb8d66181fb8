#include "numeric/number/dense_lu.hpp"
#include "numeric/variational/bordered_system.hpp"

namespace steadyslide::numeric::variational {
namespace {

/// Unknowns: pressures, approach, tilt. Equations: cells, load, moment.
class Dense : public BorderedSystem {
 public:
  Dense(const DiscreteProblem& problem, const CellSet& contact)
      : size_(contact.size()),
        cells_(cells_of(contact)),
        loads_(problem.load_at() ? 2 : 1),
        matrix_(matrix(problem)),
        lu_(matrix_) {}

  SystemSolution solve(std::span<const double> rhs, std::array<double, 2> loads) override {
    const auto n = static_cast<Eigen::Index>(cells_.size());
    Eigen::VectorXd right(n + loads_);
    for (Eigen::Index j = 0; j < n; ++j) right(j) = rhs[cells_[static_cast<std::size_t>(j)]];
    for (Eigen::Index k = 0; k < loads_; ++k) right(n + k) = loads[static_cast<std::size_t>(k)];
    const Eigen::VectorXd found = lu_.solve(right);
    SystemSolution& result = last_;
    result.residual = n == 0 ? 0 : (matrix_.topRows(n) * found - right.head(n)).cwiseAbs().maxCoeff();
    result.state.pressure.assign(size_, 0);
    for (Eigen::Index j = 0; j < n; ++j) result.state.pressure[cells_[static_cast<std::size_t>(j)]] = found(j);
    result.state.approach = found(n);
    if (loads_ == 2) result.state.tilt = found(n + 1);
    return result;
  }

  SystemSolution refined(double) override { return last_; }

 private:
  Eigen::MatrixXd matrix(const DiscreteProblem& problem) const {
    const CellMesh& mesh = problem.mesh();
    const auto n = static_cast<Eigen::Index>(cells_.size());
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n + loads_, n + loads_);
    for (Eigen::Index j = 0; j < n; ++j) {
      const std::size_t cell = cells_[static_cast<std::size_t>(j)];
      for (Eigen::Index i = 0; i < n; ++i) {
        result(i, j) = problem.galerkin_operator().entry(cells_[static_cast<std::size_t>(i)], cell);
      }
      result(j, n) = -1;
      result(n, j) = mesh.length(cell);
      if (loads_ == 1) continue;
      result(j, n + 1) = problem.place(cell);
      result(n + 1, j) = mesh.length(cell) * mesh.centre(cell);
    }
    return result;
  }

  std::size_t size_;
  std::vector<std::size_t> cells_;
  Eigen::Index loads_;
  Eigen::MatrixXd matrix_;
  DenseLu lu_;
  SystemSolution last_;
};

}  // namespace

std::unique_ptr<BorderedSystem> dense_system(const DiscreteProblem& problem, const CellSet& contact) {
  return std::make_unique<Dense>(problem, contact);
}

SystemSolution solve(BorderedSystem& system, const DiscreteProblem& problem) {
  std::vector<double> rhs(problem.size());
  for (std::size_t i = 0; i < rhs.size(); ++i) rhs[i] = -problem.profile()[i];
  return system.solve(rhs, {1, problem.load_at().value_or(0)});
}

}  // namespace steadyslide::numeric::variational
