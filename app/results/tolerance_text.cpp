#include "app/results/tolerance_text.hpp"

#include "enclosure/loads/tolerance_band.hpp"

namespace steadyslide::app {
namespace {

using enclosure::Ball;
using library::NumberText;

constexpr enclosure::Bits tolerance_bits = 64;
constexpr int shown_digits = 6;

/// Returns the number with its error; unknown if the text is empty.
Ball ball_of(const NumberText& number) {
  if (number.value.empty()) return Ball::unknown(tolerance_bits);
  const auto part = [](const std::string& text) { return Ball(parse_rational(text), tolerance_bits); };
  return Ball::plus_or_minus(part(number.value), part(number.error));
}

IntervalText interval_text(const Ball& ball) {
  return {library::lower_text(ball, shown_digits), library::upper_text(ball, shown_digits)};
}

}  // namespace

ToleranceText tolerance_text(const ContactProblem& problem, const Tolerance& tolerance,
                             const answer::ResultantsOf<NumberText, std::string>& solved) {
  const enclosure::ToleranceBand band(problem, tolerance.profile, tolerance.friction);
  const Ball load(problem.load(), tolerance_bits);
  ToleranceText result;
  result.profile = library::exact_text(tolerance.profile);
  result.friction = library::exact_text(tolerance.friction);
  result.energy = library::upper_text(band.energy());
  result.proved = solved.effective_friction.proved;
  for (std::size_t k = 0; k < solved.load_share.size(); ++k) {
    result.load_share.push_back(interval_text(band.load_share(k, ball_of(solved.load_share[k]))));
    result.proved = result.proved && solved.load_share[k].proved;
  }
  const Ball friction = band.effective_friction(ball_of(solved.effective_friction));
  result.effective_friction = interval_text(friction);
  result.friction_force = interval_text(load * friction);
  return result;
}

}  // namespace steadyslide::app
