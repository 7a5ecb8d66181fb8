#include "numeric/bodies/fixed_point.hpp"

#include <Eigen/QR>

namespace steadyslide::numeric {

Eigen::VectorXd AndersonIteration::next(const Eigen::VectorXd& x, const Eigen::VectorXd& residual) {
  Eigen::VectorXd result = x + residual;
  const auto pairs = static_cast<Eigen::Index>(places_.size());
  if (pairs > 0) {
    Eigen::MatrixXd steps(x.size(), pairs), changes(x.size(), pairs);
    for (Eigen::Index k = 0; k < pairs; ++k) {
      const auto pair = static_cast<std::size_t>(k);
      // Columns of length 1: the first changes are many orders of magnitude larger than the last ones.
      changes.col(k) = residual - residuals_[pair];
      const double length = changes.col(k).norm();
      const double scale = length > 0 ? 1 / length : 0;
      changes.col(k) *= scale;
      steps.col(k) = scale * (x - places_[pair]);
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(changes);
    solver.setThreshold(1e-12);
    result -= (steps + changes) * solver.solve(residual);
  }
  places_.push_back(x);
  residuals_.push_back(residual);
  if (places_.size() > most_pairs) {
    places_.erase(places_.begin());
    residuals_.erase(residuals_.begin());
  }
  return result;
}

}  // namespace steadyslide::numeric
