#include "proofs_checks/instruments/cells/dense_algebra.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace steadyslide::proofs_checks {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd eigenvalues(const MatrixXd& a) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(a, Eigen::EigenvaluesOnly).eigenvalues();
}

VectorXd eigenvalues(const MatrixXd& a, const MatrixXd& b) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(a, b, Eigen::EigenvaluesOnly).eigenvalues();
}

double spectral_norm(const MatrixXd& a) { return Eigen::JacobiSVD<MatrixXd>(a).singularValues()(0); }

MatrixXd in_metric(const MatrixXd& form, const MatrixXd& metric) {
  const Eigen::LLT<MatrixXd> factors(metric);
  const MatrixXd half = factors.matrixL().solve(form);
  return factors.matrixL().solve(half.transpose()).transpose();
}

VectorXd linear_solution(const MatrixXd& a, const VectorXd& b) { return a.partialPivLu().solve(b); }

MatrixXd definite_solution(const MatrixXd& a, const MatrixXd& b) { return a.llt().solve(b); }

}  // namespace steadyslide::proofs_checks
