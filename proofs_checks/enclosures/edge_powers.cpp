// The powers -(1/2+alpha) and -(1/2-alpha), alpha = arctan(s)/pi, are larger than -1, because |alpha| < 1/2 for s in an
// interval. arctan increases. Towards infinity 1/2 - alpha = arctan(y)/pi, y = 1/s, and arctan(y)/y = 1/(1+eta^2) with
// 0 < eta < y.

#include "proofs_checks/enclosures/enclosure_list.hpp"

namespace steadyslide::proofs_checks {
namespace {

using enclosure::Ball;

/// Returns a ball that contains arctan(s)/pi on the interval. At an infinite end this is +-1/2.
Ball angle(const Interval& s) {
  const auto at = [](const std::optional<Rational>& end, int sign) {
    return end ? Ball(Exponent::angle(*end), sign_bits) : Ball(sign, sign_bits) / 2;
  };
  return Ball::hull(at(s.from, -1), at(s.to, 1));
}

/// True if arctan(s)/pi < 1/2 is decided on the interval. If the interval is unbounded, the reason is arctan(y)/y > 0
/// for 0 < y <= 1/max(from, 1).
bool below_half(const std::optional<Rational>& from, const std::optional<Rational>& to) {
  if (to) return Ball(Exponent::angle(*to), sign_bits) < Ball(1, sign_bits) / 2;
  const Rational least = from && *from > 1 ? *from : Rational(1);
  const Ball eta = Ball::hull(Ball(0, sign_bits), Ball(1 / least, sign_bits));
  return (1 / (1 + eta * eta)).is_positive();
}

Decision decided(bool holds, const Ball& alpha) {
  return {holds ? Truth::yes : Truth::unknown, {"`alpha = arctan(s)/pi` in " + alpha.to_string(6)}};
}

Decision powers(const Box& box) {
  const Interval s = box.at("s");
  std::optional<Rational> least, most;  // bounds of -s
  if (s.from) most = -*s.from;
  if (s.to) least = -*s.to;
  return decided(below_half(s.from, s.to) && below_half(least, most), angle(s));
}

/// Wrong variant: the left power lowered by 1 needs alpha < -1/2, the right one alpha > 1/2. `no` if this fails at one
/// point of the interval.
Decision lower_power(const Box& box, int sign) {
  const Interval s = box.at("s");
  const Rational place = s.from ? *s.from : s.to ? *s.to : Rational(0);
  const Ball alpha = Ball(Exponent::angle(place), sign_bits) * sign;
  return {alpha > -Ball(1, sign_bits) / 2 ? Truth::no : Truth::unknown, {"alpha = " + alpha.to_string(6)}};
}

/// Wrong variant: |s| < 1/2 in place of |alpha| < 1/2.
Decision without_arctan(const Box& box) {
  const Interval s = box.at("s");
  const Rational half(1, 2);
  const bool beyond = !s.from || !s.to || *s.from < -half || *s.to > half;
  return {beyond ? Truth::no : Truth::unknown, {"an s beyond 1/2"}};
}

}  // namespace

Enclosure edge_powers() {
  return {"edge-powers",
          powers,
          {{"`-(3/2+alpha) > -1`", [](const Box& box) { return lower_power(box, 1); }},
           {"`-(3/2-alpha) > -1`", [](const Box& box) { return lower_power(box, -1); }},
           {"`s` for `arctan(s)/pi`", without_arctan}}};
}

}  // namespace steadyslide::proofs_checks
