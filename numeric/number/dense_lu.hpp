#pragma once
// A square matrix of doubles, factorised once with row pivots. Only this file compiles Eigen's LU.

#include <Eigen/Core>
#include <memory>

namespace steadyslide::numeric {

class DenseLu {
 public:
  explicit DenseLu(const Eigen::MatrixXd& matrix);

  /// Returns the solution; not finite if the matrix is singular.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;
  Eigen::MatrixXd inverse() const;

 private:
  std::shared_ptr<const Eigen::PartialPivLU<Eigen::MatrixXd>> lu_;
};

}  // namespace steadyslide::numeric
