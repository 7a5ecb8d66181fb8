#pragma once
// Eigenvalues, norms and linear systems of dense matrices, in double. Among the claims, only this source compiles
// Eigen's decompositions, because each takes the compiler seconds.

#include <Eigen/Core>

namespace steadyslide::proofs_checks {

/// Returns the matrix with the entries f(i, j).
template <class F>
Eigen::MatrixXd matrix_of(std::size_t rows, std::size_t columns, const F& f) {
  using Eigen::Index;
  return Eigen::MatrixXd::NullaryExpr(static_cast<Index>(rows), static_cast<Index>(columns), [&](Index i, Index j) {
    return f(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  });
}
template <class F>
Eigen::VectorXd vector_of(std::size_t size, const F& f) {
  return matrix_of(size, 1, [&](std::size_t i, std::size_t) { return f(i); });
}

/// Returns the eigenvalues of a symmetric matrix in increasing order.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a);
/// Returns the eigenvalues lambda of a x = lambda b x in increasing order; a and b are symmetric, b is positive
/// definite.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Returns the largest singular value.
double spectral_norm(const Eigen::MatrixXd& a);
/// Returns the form in coordinates in which `metric`, symmetric and positive definite, is the identity.
Eigen::MatrixXd in_metric(const Eigen::MatrixXd& form, const Eigen::MatrixXd& metric);

/// Solves a x = b for any invertible matrix a.
Eigen::VectorXd linear_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
/// Solves a x = b for each column of b; a is symmetric and positive definite.
Eigen::MatrixXd definite_solution(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace steadyslide::proofs_checks
