#pragma once
// Anderson's acceleration of a fixed-point iteration x = F(x). For linear F it is GMRES on x - F(x).

#include <Eigen/Core>
#include <vector>

namespace steadyslide::numeric {

class AndersonIteration {
 public:
  /// Takes x and F(x) - x, and returns the next x: the combination of all pairs with the least residual, plus it.
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& residual);

 private:
  static constexpr std::size_t most_pairs = 40;
  std::vector<Eigen::VectorXd> places_;
  std::vector<Eigen::VectorXd> residuals_;
};

}  // namespace steadyslide::numeric
