#include "enclosure/number/ball.hpp"
#include "proofs_checks/enclosures/enclosure_list.hpp"

namespace steadyslide::proofs_checks {
namespace {

using enclosure::Ball;

constexpr enclosure::Bits digit_bits = 128;

/// Decides sign pi sqrt(radicand)/3^{power} in ]-1.949054259166748, -1.949054259166747[, the interval moved by `shift`.
Enclosure::Decide galin_digits(int radicand, const Rational& power_of_three, int sign = -1, const char* shift = "0") {
  return [=](const Box&) -> Decision {
    const auto number = [](const char* text) { return Ball(parse_rational(text), digit_bits); };
    const Ball value = sign * Ball::pi(digit_bits) * sqrt(Ball(radicand, digit_bits)) /
                       power(Ball(3, digit_bits), Ball(power_of_three, digit_bits));
    const Ball from = number("-1.949054259166748") + number(shift);
    const Ball to = number("-1.949054259166747") + number(shift);
    const Truth within = value > from && value < to   ? Truth::yes
                         : value < from || value > to ? Truth::no
                                                      : Truth::unknown;
    return {within, {value.to_string(20)}};
  };
}

}  // namespace

Enclosure galin_at_two() {
  const Rational power(3, 4);
  return {"galin-at-2",
          galin_digits(2, power),
          {{"the other sign", galin_digits(2, power, 1)},
           {"`3^{1/4}`", galin_digits(2, Rational(1, 4))},
           {"without `sqrt(2)`", galin_digits(1, power)},
           {"another last digit", galin_digits(2, power, -1, "0.000000000000001")}}};
}

}  // namespace steadyslide::proofs_checks
