#include "enclosure/quadrature/trapezoidal.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace steadyslide::enclosure {
namespace {

constexpr Bits bound_bits = 64;

/// d and h, chosen in double.
struct Strip {
  double half_width;
  double step;
};

/// Returns the largest h over all d for which e^(-2 pi d/h) cos(d/2)^-exponent is e^-digits, by golden section.
Strip best_strip(double digits, double exponent) {
  constexpr double golden = 0.6180339887498949;
  const auto step = [&](double gap) {
    const double d = std::numbers::pi - gap;
    return 2 * std::numbers::pi * d / (digits - exponent * std::log(std::sin(gap / 2)));
  };
  double low = 1e-6, high = 1.5;
  for (int k = 0; k < 60; ++k) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    (step(left) > step(right) ? high : low) = step(left) > step(right) ? right : left;
  }
  return {std::numbers::pi - (low + high) / 2, step((low + high) / 2)};
}

/// Returns the number of nodes after which the geometric tail e^(-rate tau) is e^-digits; at most `most`, for which the
/// bound of the tail is still valid.
int nodes_beyond(double digits, double rate, double step, double centre) {
  constexpr double most = 1e6;
  const double tail = digits - std::log(-std::expm1(-rate * step)) + 2;
  return static_cast<int>(std::clamp(std::ceil((tail / rate + centre) / step), 1.0, most));
}

/// Returns e^-(tau - tau_p) at the node k.
Ball shift_at(const Ball& h, int k) { return exp(-h * (2 * k + 1) / 2); }

Ball beta(const Ball& a, const Ball& b) { return gamma(a) * gamma(b) / gamma(a + b); }

}  // namespace

Trapezoidal::Trapezoidal(const Ball& length, const Ball& left, const Ball& right,
                         const std::vector<OutsidePoint>& outside, const std::optional<Pole>& pole, int degree,
                         Bits bits)
    : bits_(bits) {
  const bool valid = left > -1 && right > -1 && length.is_positive() &&
                     (!pole || (pole->from_left.is_positive() && pole->from_right.is_positive())) &&
                     std::all_of(outside.begin(), outside.end(), [](const OutsidePoint& point) {
                       return point.distance.is_positive() && point.power.is_finite();
                     });
  if (!valid) throw std::invalid_argument("trapezoidal rule: powers > -1, lengths > 0");

  const Ball a = left.at(bound_bits) + 1, b = right.at(bound_bits) + 1;
  Ball outside_powers(0, bound_bits), largest(1, bound_bits), middle(1, bound_bits);
  for (const OutsidePoint& point : outside) {
    const Ball near = point.distance.at(bound_bits), far = near + length.at(bound_bits), p = point.power.at(bound_bits);
    outside_powers += abs(p);
    largest *= max(power(near, p), power(far, p));
    middle *= power((near + far) / 2, p);
  }

  // The accuracy is relative to the integrand in the middle.
  const double excess = std::max(0.0, rough_log2(largest) - rough_log2(middle));
  const double digits = (static_cast<double>(bits) + excess) * std::numbers::ln2;
  const double exponent = (a + b + outside_powers).to_double() + degree;
  const Strip strip = best_strip(digits, exponent);

  const Bits working = bits + 32;
  const Ball h = Ball::exactly(strip.step, working), d = Ball::exactly(strip.half_width, working);
  const Ball one = Ball(1, working), l = length.at(working);
  // e^-tau_p = (L - p)/p; without a pole nodes are at (k + 1/2) h.
  const Ball at_pole = pole ? pole->from_right.at(working) / pole->from_left.at(working) : one;
  const Ball tau_pole = -log(at_pole);
  const int below = nodes_beyond(digits, a.to_double(), strip.step, tau_pole.to_double());
  const int above = nodes_beyond(digits, b.to_double(), strip.step, -tau_pole.to_double());

  const Ball scale = h * power(l, left.at(working) + right.at(working) + 1);
  const Ball factor = exp(-h);
  Ball shift = shift_at(h, -below);
  nodes_.reserve(static_cast<std::size_t>(below + above));
  for (int k = -below; k < above; ++k, shift *= factor) {
    const Ball e = at_pole * shift, sum = 1 + e, log_sum = log(sum);
    const Ball tau = tau_pole + h * (2 * k + 1) / 2;
    Ball exponents = -(left + 1) * log_sum - (right + 1) * (log_sum + tau);
    for (const OutsidePoint& point : outside) {
      const Ball far = l + point.distance;
      const Ball numerator = point.side == Side::left ? far + point.distance * e : far * e + point.distance;
      exponents += point.power * (log(numerator) - log_sum);
    }
    Ball weight = scale * exp(exponents);
    // y - p = p e^-tau_p (1 - e^-(tau-tau_p))/(1 + e^-tau): digits are lost only next to the pole.
    if (pole) weight *= sum / (pole->from_left * at_pole * (1 - shift));
    nodes_.push_back({(l / sum).at(bits), (l * e / sum).at(bits), weight.at(bits)});
  }

  // The bounds in the header.
  const Ball half = d.at(bound_bits) / 2, k = cos(half);
  const Ball size = (power(l.at(bound_bits), a + b - 1) * largest).upper();
  Ball lines = 2 * power(k, -(a + b + outside_powers)) * beta(a, b) / (exp(Ball::pi(bound_bits) * 2 * d / h) - 1);
  // The first omitted nodes on both sides.
  const Ball e_below = at_pole * shift_at(h, -below - 1), e_above = at_pole * shift_at(h, above);
  Ball low = power(1 / e_below, a) / (1 - exp(-a * h)) * h, high = power(e_above, b) / (1 - exp(-b * h)) * h;
  if (pole) {
    const Ball p = pole->from_left.at(bound_bits), q = pole->from_right.at(bound_bits);
    lines *= max(1 / p, 1 / q) / sin(half);
    const Ball before = p - l / (1 + e_below), behind = q - l * e_above / (1 + e_above);
    low = before.is_positive() ? low / before : Ball::unknown(bound_bits);
    high = behind.is_positive() ? high / behind : Ball::unknown(bound_bits);
  }
  remainder_ = (size * (lines + low + high)).upper();
  lens_radius_ = (l.at(bound_bits) / 2 * sin(half) / k).upper();
}

}  // namespace steadyslide::enclosure
