#include "numeric/number/dense_lu.hpp"

#include <Eigen/LU>

namespace steadyslide::numeric {

DenseLu::DenseLu(const Eigen::MatrixXd& matrix)
    : lu_(std::make_shared<const Eigen::PartialPivLU<Eigen::MatrixXd>>(matrix)) {}

Eigen::VectorXd DenseLu::solve(const Eigen::VectorXd& right) const { return lu_->solve(right); }
Eigen::MatrixXd DenseLu::solve(const Eigen::MatrixXd& right) const { return lu_->solve(right); }
Eigen::MatrixXd DenseLu::inverse() const { return lu_->inverse(); }

}  // namespace steadyslide::numeric
