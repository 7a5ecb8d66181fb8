#pragma once
// Eigenvalues, norms and linear systems of dense matrices, in double. Eigen's decompositions are compiled here and
// nowhere else among the claims: each of them takes a compiler seconds.

#include <Eigen/Core>

namespace steadyslide::proofs_checks {

/// f(i, j) at each place.
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

/// Of a symmetric matrix, in increasing order.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a);
/// lambda of a x = lambda b x, in increasing order; both symmetric, b positive definite.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// The largest singular value.
double spectral_norm(const Eigen::MatrixXd& a);
/// A form in coordinates in which the symmetric, positive definite `metric` is the identity.
Eigen::MatrixXd in_metric(const Eigen::MatrixXd& form, const Eigen::MatrixXd& metric);

/// a x = b with any invertible matrix.
Eigen::VectorXd linear_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
/// a x = b for each column of b, a symmetric and positive definite.
Eigen::MatrixXd definite_solution(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace steadyslide::proofs_checks
