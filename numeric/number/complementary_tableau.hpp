#pragma once
// Complementary pivots: the path of the points with  x_k >= 0, y_k >= 0, x_k y_k = 0  for all k but for one free
// parameter, of variables that are tied by linear equations.
//
// The equations have the form of a dictionary, (variables on the left) = constants + matrix (variables on the right).
// A path moves along one right variable at a time until a left one becomes zero; the two change places, and the partner
// of the one that left goes on. With one constant for each row in general position no two become zero at once, every
// point of the path has two ways out, and the path never comes back to where it was. [CPS92, section 4.4]

#include <Eigen/Core>
#include <vector>

namespace steadyslide::numeric {

class ComplementaryTableau {
 public:
  using Index = Eigen::Index;
  /// Variables have the numbers 0..pairs-1 (x), pairs..2*pairs-1 (y), and from 2*pairs on the free ones: those may have
  /// any sign and never leave the left side on a path; one that has been exchanged to the right stays zero.
  ComplementaryTableau(Index pairs, std::vector<Index> left, std::vector<Index> right, Eigen::MatrixXd matrix,
                       Eigen::VectorXd constants);

  /// Exchanges a left and a right variable, whatever their values.
  void exchange(Index left, Index right);

  enum class End {
    reached,  ///< the measured variable has its target value
    ray,      ///< nothing becomes zero any more
    stopped   ///< as many pivots as allowed, or rounding left no pivot
  };
  /// From the present point, at which the two partners of `entering`'s pair stand on the right. `measured` is a free
  /// variable on the left. With `reached`, `entering` moves to where the target is met.
  End follow(Index entering, Index measured, double target, int most_pivots);

  int pivots() const { return pivots_; }
  /// Is the variable on the left, or the one that was moving when the path ended?
  bool is_positive(Index variable) const { return row_of(variable) >= 0 || variable == moving_; }
  /// The left variables' values, where the right ones are zero, by row; the variables by row.
  const Eigen::VectorXd& constants() const { return constants_; }
  const std::vector<Index>& left() const { return left_; }

 private:
  Index row_of(Index variable) const { return place_[static_cast<std::size_t>(variable)]; }
  Index column_of(Index variable) const { return -1 - place_[static_cast<std::size_t>(variable)]; }
  Index partner(Index variable) const { return variable < pairs_ ? variable + pairs_ : variable - pairs_; }
  void place(std::vector<Index>& side, Index at, Index variable);
  Index first_to_vanish(const Eigen::VectorXd& column, double& way) const;
  /// The largest error of the equations, of the present point.
  double drift() const;
  void factorise();

  Index pairs_;
  std::vector<Index> left_;
  std::vector<Index> right_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd constants_;
  // The dictionary as it was given: rounding errors grow with every pivot, and from it all can be had again.
  std::vector<Index> first_left_;
  std::vector<Index> first_right_;
  Eigen::MatrixXd first_matrix_;
  Eigen::VectorXd first_constants_;
  std::vector<Index> place_;  // row, or -1 - column
  Index moving_ = -1;
  int pivots_ = 0;
};

}  // namespace steadyslide::numeric
