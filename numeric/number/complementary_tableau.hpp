#pragma once
// Complementary pivots for variables that satisfy linear equations: the path of points with x_k >= 0, y_k >= 0, x_k
// y_k = 0 for all k, where one parameter is free.
//
// The equations have the form of a dictionary, (variables on the left) = constants + matrix (variables on the right).
// A path changes one right variable until a left one becomes zero. The two variables are exchanged, and then the
// partner of the one that became zero changes. With constants in general position no two variables become zero at once.
// So the path has two directions at every point and never returns to an earlier point. [CPS92, section 4.4]

#include <Eigen/Core>
#include <vector>

namespace steadyslide::numeric {

class ComplementaryTableau {
 public:
  using Index = Eigen::Index;
  /// Variables have the numbers 0..pairs-1 (x), pairs..2*pairs-1 (y), and from 2*pairs on (free variables). A free
  /// variable may have any sign and never leaves the left side on a path; one that was exchanged to the right stays
  /// zero.
  ComplementaryTableau(Index pairs, std::vector<Index> left, std::vector<Index> right, Eigen::MatrixXd matrix,
                       Eigen::VectorXd constants);

  /// Exchanges a left and a right variable, for any values.
  void exchange(Index left, Index right);

  enum class End {
    reached,  ///< the measured variable has its target value
    ray,      ///< no variable becomes zero any more
    stopped   ///< the limit of pivots is reached, or rounding leaves no pivot
  };
  /// Follows the path from the current point, at which both variables of `entering`'s pair are on the right. `measured`
  /// is a free variable on the left. If the result is `reached`, `entering` has the value at which the target is met.
  End follow(Index entering, Index measured, double target, int most_pivots);

  int pivots() const { return pivots_; }
  /// True if the variable is on the left, or if it was changing when the path ended.
  bool is_positive(Index variable) const { return row_of(variable) >= 0 || variable == moving_; }
  /// The values of the left variables by row, where the right ones are zero; the variables by row.
  const Eigen::VectorXd& constants() const { return constants_; }
  const std::vector<Index>& left() const { return left_; }

 private:
  Index row_of(Index variable) const { return place_[static_cast<std::size_t>(variable)]; }
  Index column_of(Index variable) const { return -1 - place_[static_cast<std::size_t>(variable)]; }
  Index partner(Index variable) const { return variable < pairs_ ? variable + pairs_ : variable - pairs_; }
  void place(std::vector<Index>& side, Index at, Index variable);
  Index first_to_vanish(const Eigen::VectorXd& column, double& way) const;
  /// Returns the largest error of the equations at the current point.
  double drift() const;
  void factorise();

  Index pairs_;
  std::vector<Index> left_;
  std::vector<Index> right_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd constants_;
  // The original dictionary. Rounding errors grow with every pivot; from this the current one can be computed anew.
  std::vector<Index> first_left_;
  std::vector<Index> first_right_;
  Eigen::MatrixXd first_matrix_;
  Eigen::VectorXd first_constants_;
  std::vector<Index> place_;  // row, or -1 - column
  Index moving_ = -1;
  int pivots_ = 0;
};

}  // namespace steadyslide::numeric
