#include "enclosure/loads/tolerance_band.hpp"

#include <algorithm>

#include "model/invalid_data.hpp"

namespace steadyslide::enclosure {
namespace {

constexpr Bits tolerance_bits = 64;

/// Returns the interval of the numbers at most `deviation` from a number in the ball, within [low, high].
Ball widened(const Ball& ball, const Ball& deviation, const Rational& low, const Rational& high) {
  const Ball limits = Ball::hull(Ball(low, tolerance_bits), Ball(high, tolerance_bits));
  return limits.intersection(Ball::plus_or_minus(ball, deviation));
}

}  // namespace

ToleranceBand::ToleranceBand(const ContactProblem& problem, const Rational& profile, const Rational& friction)
    : problem_(problem), friction_tolerance_(friction) {
  const std::vector<Rational>& jumps = problem.friction().jumps();
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    rises_.push_back(problem.coupled_friction(k + 1) - problem.coupled_friction(k));
    if (rises_.back() < 0) {
      throw InvalidData("no bound where s = +-gamma f decreases towards +x, at x = " + to_string(jumps[k]));
    }
  }
  const Elasticity& elasticity = problem.elasticity();
  const Rational gamma = abs(elasticity.gamma());
  energy_ = Ball(Rational(2 * profile / (elasticity.compliance() * problem.load()) + gamma * friction), tolerance_bits);
}

Ball ToleranceBand::deviation(const Rational& sum) const { return sqrt(Ball(2) * energy_ * Ball(sum, tolerance_bits)); }

Ball ToleranceBand::load_share(std::size_t k, const Ball& share) const {
  Rational sum = 0;
  for (const std::size_t end : {k, k + 1}) {
    if (end == 0 || end > rises_.size()) continue;
    if (rises_[end - 1] == 0) return widened(share, Ball(1), 0, 1);
    sum += 1 / rises_[end - 1];
  }
  return widened(share, deviation(sum), 0, 1);
}

Ball ToleranceBand::effective_friction(const Ball& friction) const {
  const std::vector<Rational>& values = problem_.friction().values();
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  const Rational low = std::max(Rational(0), Rational(*least - friction_tolerance_));
  const Rational high = *largest + friction_tolerance_;
  Rational sum = 0;
  bool bounded = true;
  for (std::size_t k = 0; k < rises_.size(); ++k) {
    const Rational jump = values[k + 1] - values[k];
    bounded = bounded && (jump == 0 || rises_[k] != 0);
    if (rises_[k] != 0) sum += jump * jump / rises_[k];
  }
  const Ball moved = bounded ? deviation(sum) + Ball(friction_tolerance_, tolerance_bits) : Ball(high, tolerance_bits);
  return widened(friction, moved, low, high);
}

}  // namespace steadyslide::enclosure
