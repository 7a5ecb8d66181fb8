#include "enclosure/quadrature/power_panel.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace steadyslide::enclosure {
namespace {

/// The data for the choice of rho: outside points in units of half the panel, as doubles.
class RemainderEstimate {
 public:
  /// Absent if a distance is not a positive double in these units.
  static std::optional<RemainderEstimate> make(const Ball& length, const std::vector<OutsidePoint>& outside) {
    RemainderEstimate estimate;
    double nearest = std::numeric_limits<double>::infinity();
    for (const OutsidePoint& point : outside) {
      const double distance = (2 * point.distance.lower() / length.upper()).to_double();
      if (!(distance > 0)) return std::nullopt;
      nearest = std::min(nearest, distance);
      const double power = point.power.to_double();
      // Far places contribute a constant.
      if (power != 0 && distance < 1e9) estimate.points_.push_back({1 + distance, power});
    }
    // (rho + 1/rho)/2 - 1 = nearest, or slightly less.
    const double end = 1 + nearest + std::sqrt(nearest * (2 + nearest));
    estimate.largest_ = std::min(1 + (end - 1) * (1 - 1e-6), PowerPanel::largest_rho);
    if (!(estimate.largest_ > 1)) return std::nullopt;
    return estimate;
  }

  /// The smallest logarithm of the remainder with n nodes divided by the largest value on the panel, and its rho, found
  /// by golden section in log(rho - 1).
  struct Choice {
    double rho;
    double log_remainder;
  };
  Choice best(int n) const {
    constexpr double golden = 0.6180339887498949;
    double high = std::log(largest_ - 1);
    double low = high - 12;
    double left = high - golden * (high - low), right = low + golden * (high - low);
    double at_left = at(n, left), at_right = at(n, right);
    for (int step = 0; step < 24; ++step) {
      if (at_left < at_right) {
        high = right, right = left, at_right = at_left;
        at_left = at(n, left = high - golden * (high - low));
      } else {
        low = left, left = right, at_left = at_right;
        at_right = at(n, right = low + golden * (high - low));
      }
    }
    const double middle = (low + high) / 2;
    return {1 + std::exp(middle), at(n, middle)};
  }

 private:
  struct PowerPoint {
    double from_centre;
    double power;
  };

  double at(int n, double log_excess) const {
    const double rho = 1 + std::exp(log_excess);
    const double axis = (rho + 1 / rho) / 2;
    double result = std::log(4.0) + (1 - 2 * n) * std::log(rho) - log_excess;
    for (const auto& [from_centre, power] : points_) {
      const double ratio =
          power < 0 ? (from_centre - axis) / (from_centre - 1) : (from_centre + axis) / (from_centre + 1);
      result += power * std::log(ratio);
    }
    return result;
  }

  double largest_ = 0;
  std::vector<PowerPoint> points_;
};

}  // namespace

PowerPanel::PowerPanel(const Ball& length, const Ball& left, const Ball& right, std::vector<OutsidePoint> outside,
                       int count, JacobiRules& rules)
    : length_(length.at(rules.bits())) {
  const Bits bits = rules.bits();
  const JacobiRule& rule = rules(count, left, right);
  const auto estimate = RemainderEstimate::make(length_, outside);
  const OutsideProduct product(std::move(outside));
  const Ball half = length_ / 2;
  rho_ = estimate ? Ball::exactly(estimate->best(count).rho, bits) : Ball::unknown(bits);
  reach_ = half * ((rho_ + 1 / rho_) / 2 - 1);
  const Ball scale = power(half, left.at(bits) + right.at(bits) + 1);
  // Sums over nodes of weight F are as accurate as their terms; only the bounds are coarse.
  remainder_ = (scale.at(64) * rule.remainder(product.bound(length_, reach_), rho_)).upper();
  polynomial_remainder_ = product.points().empty() ? (scale.at(64) * rule.remainder(Ball(1, 64))).upper() : remainder_;
  nodes_.reserve(rule.size());
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const Ball from_left = half * rule.from_left[i], from_right = half * rule.from_right[i];
    nodes_.push_back({from_left, from_right, scale * rule.weights[i] * product.at(from_left, from_right)});
  }
}

int PowerPanel::count_for(Bits bits, double rho) {
  const double needed = static_cast<double>(bits) + std::log2(4 * rho / (rho - 1));
  return std::max(1, static_cast<int>(std::ceil(needed / (2 * std::log2(rho)))));
}

int PowerPanel::count_for(Bits bits, const Ball& length, const std::vector<OutsidePoint>& outside) {
  constexpr int most = 100000;
  const auto estimate = RemainderEstimate::make(length, outside);
  if (!estimate) return 0;
  const double wanted = -static_cast<double>(bits) * std::log(2.0);
  // The remainder decreases with n, so bisection works.
  int few = 0, enough = 16;
  while (estimate->best(enough).log_remainder > wanted) {
    few = enough;
    enough *= 2;
    if (enough > most) return 0;
  }
  while (enough - few > 1) {
    const int middle = (few + enough) / 2;
    (estimate->best(middle).log_remainder > wanted ? few : enough) = middle;
  }
  return enough;
}

Ball PowerPanel::remainder_of_principal_value(const Ball& bound_of_F) const {
  // The ellipse's half-height is (L/2) (rho - 1/rho)/2.
  return remainder(2 * bound_of_F / (length_ / 4 * (rho_ - 1 / rho_)));
}

}  // namespace steadyslide::enclosure
