#include "numeric/number/complementary_tableau.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/number/dense_lu.hpp"

namespace steadyslide::numeric {
namespace {

using Eigen::Index;

/// Smaller entries, relative to the largest of a column, may be rounding errors and are not used as pivots.
constexpr double negligible = 1e-11;
/// The drift, relative to the constants, above which the tableau is computed anew, and the number of pivots between
/// checks.
constexpr double allowed_drift = 1e-12;
constexpr int between_looks = 32;

}  // namespace

ComplementaryTableau::ComplementaryTableau(Index pairs, std::vector<Index> left, std::vector<Index> right,
                                           Eigen::MatrixXd matrix, Eigen::VectorXd constants)
    : pairs_(pairs),
      left_(std::move(left)),
      right_(std::move(right)),
      matrix_(std::move(matrix)),
      constants_(std::move(constants)),
      first_left_(left_),
      first_right_(right_),
      first_matrix_(matrix_),
      first_constants_(constants_),
      place_(left_.size() + right_.size()) {
  for (std::size_t i = 0; i < left_.size(); ++i) place(left_, static_cast<Index>(i), left_[i]);
  for (std::size_t j = 0; j < right_.size(); ++j) place(right_, static_cast<Index>(j), right_[j]);
}

void ComplementaryTableau::place(std::vector<Index>& side, Index at, Index variable) {
  side[static_cast<std::size_t>(at)] = variable;
  place_[static_cast<std::size_t>(variable)] = &side == &left_ ? at : -1 - at;
}

void ComplementaryTableau::exchange(Index left, Index right) {
  const Index r = row_of(left);
  const Index e = column_of(right);
  Eigen::VectorXd column = matrix_.col(e);
  const double pivot = column(r);
  // The column of the exchanged variable: -1 becomes 1/pivot.
  matrix_.col(e).setZero();
  matrix_(r, e) = -1;
  const Eigen::RowVectorXd row = -matrix_.row(r) / pivot;
  const double constant = -constants_(r) / pivot;
  column(r) = 0;
  matrix_.noalias() += column * row;
  constants_ += constant * column;
  matrix_.row(r) = row;
  constants_(r) = constant;
  place(left_, r, right);
  place(right_, e, left);
}

double ComplementaryTableau::drift() const {
  Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Index>(first_right_.size()));
  for (std::size_t j = 0; j < first_right_.size(); ++j) {
    const Index row = row_of(first_right_[j]);
    if (row >= 0) right(static_cast<Index>(j)) = constants_(row);
  }
  Eigen::VectorXd error = first_constants_ + first_matrix_ * right;
  for (std::size_t i = 0; i < first_left_.size(); ++i) {
    const Index row = row_of(first_left_[i]);
    if (row >= 0) error(static_cast<Index>(i)) -= constants_(row);
  }
  return error.cwiseAbs().maxCoeff();
}

void ComplementaryTableau::factorise() {
  // The original equations, (variables on the left) - matrix (variables on the right) = constants: the columns of the
  // variables that are now on the left, and of the others.
  const auto rows = static_cast<Index>(left_.size());
  const auto columns = static_cast<Index>(right_.size());
  std::vector<Index> first(place_.size());
  for (Index i = 0; i < rows; ++i) first[static_cast<std::size_t>(first_left_[static_cast<std::size_t>(i)])] = i;
  for (Index j = 0; j < columns; ++j) {
    first[static_cast<std::size_t>(first_right_[static_cast<std::size_t>(j)])] = -1 - j;
  }
  const auto fill = [&](auto&& column, Index variable) {
    const Index at = first[static_cast<std::size_t>(variable)];
    if (at < 0) {
      column = -first_matrix_.col(-1 - at);
    } else {
      column.setZero();
      column(at) = 1;
    }
  };
  Eigen::MatrixXd left(rows, rows);
  Eigen::MatrixXd right(rows, columns + 1);
  for (Index i = 0; i < rows; ++i) fill(left.col(i), left_[static_cast<std::size_t>(i)]);
  for (Index j = 0; j < columns; ++j) fill(right.col(j), right_[static_cast<std::size_t>(j)]);
  right.leftCols(columns) *= -1;
  right.col(columns) = first_constants_;
  const Eigen::MatrixXd solved = DenseLu(left).solve(right);
  matrix_ = solved.leftCols(columns);
  constants_ = solved.col(columns);
}

Index ComplementaryTableau::first_to_vanish(const Eigen::VectorXd& column, double& way) const {
  const double least = negligible * column.cwiseAbs().maxCoeff();
  Index next = -1;
  for (Index i = 0; i < column.size(); ++i) {
    if (left_[static_cast<std::size_t>(i)] >= 2 * pairs_ || !(column(i) < -least)) continue;
    const double until = std::max(0.0, constants_(i)) / -column(i);
    if (until < way || (next >= 0 && until == way && column(i) < column(next))) {
      way = until;
      next = i;
    }
  }
  return next;
}

ComplementaryTableau::End ComplementaryTableau::follow(Index entering, Index measured, double target, int most_pivots) {
  const Index row = row_of(measured);
  const double way_up = target > constants_(row) ? 1 : -1;
  const double scale = std::max(1.0, first_constants_.cwiseAbs().maxCoeff());
  int looked = 0;
  while (true) {
    moving_ = entering;
    const Eigen::VectorXd column = matrix_.col(column_of(entering));
    if (!column.allFinite() || !constants_.allFinite()) return End::stopped;
    const double rate = way_up * column(row);
    const double until_target = rate > 0 ? std::max(0.0, way_up * (target - constants_(row)) / rate) : HUGE_VAL;
    double way = until_target;
    const Index next = first_to_vanish(column, way);
    if (next < 0) return std::isfinite(until_target) ? End::reached : End::ray;
    if (pivots_ >= most_pivots) return End::stopped;
    const Index leaving = left_[static_cast<std::size_t>(next)];
    exchange(leaving, entering);
    if (++pivots_ - looked >= between_looks) {
      looked = pivots_;
      if (drift() > allowed_drift * scale) factorise();
    }
    entering = partner(leaving);
  }
}

}  // namespace steadyslide::numeric
