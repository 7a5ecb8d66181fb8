// Galin's pressure divided by that of a triangle is 2A (w/(2-w))^eps with 2A = sin(pi eps)/(pi eps (1-eps)),
// eps = 1/2 - alpha: 1 <= 2A <= 1 + eps. For y = pi eps >= 0 the alternating series gives
// y - y^3/6 <= sin y <= y - y^3/6 + y^5/120. Therefore
//
//   1 - eps <= 1 - pi^2 eps^2/6                              if eps pi^2/6 <= 1,
//   1 - pi^2 eps^2/6 + pi^4 eps^4/120 <= (1-eps) (1+eps)     if eps^2 pi^4/120 <= pi^2/6 - 1. This follows from
//                                                            eps pi^2/6 <= 1, because 36/120 < 9/6 - 1.
//
// The condition eps pi^2/6 <= 1 is monotone in eps. It is decided at the largest eps and then holds down to eps = 0.

#include "proofs_checks/enclosures/enclosure_list.hpp"

namespace steadyslide::proofs_checks {
namespace {

using enclosure::Ball;

Ball largest(const Box& box) { return Ball(*box.at("eps").to, sign_bits); }

Decision between(const Box& box) {
  const Interval& range = box.at("eps");
  if (!range.from || *range.from < 0 || !range.to) return {Truth::unknown, {"no interval of eps >= 0"}};
  const Ball eps = largest(box);
  const Ball square = Ball::pi(sign_bits) * Ball::pi(sign_bits);
  const bool small = eps * square / 6 <= Ball(1, sign_bits);
  return {small ? Truth::yes : Truth::unknown, {"`1 <= sin(pi eps)/(pi eps (1-eps)) <= 1 + eps`"}};
}

/// Wrong variant: 2A <= 1 + slope eps, or >= with `at_least`. `no` if it fails at the largest eps, which is below 1.
Enclosure::Decide bound_at_largest(const Rational& slope, bool at_least) {
  return [=](const Box& box) -> Decision {
    const Ball eps = largest(box);
    const Ball y = Ball::pi(sign_bits) * eps;
    const Ball twice = sin(y) / (y * (1 - eps));
    const Ball bound = 1 + eps * Ball(slope, sign_bits);
    const bool wrong = at_least ? twice < bound : twice > bound;
    return {wrong ? Truth::no : Truth::unknown, {"2A = " + twice.to_string(6)}};
  };
}

}  // namespace

Enclosure triangle_amplitude() {
  return {"triangle-amplitude",
          between,
          {{"`2A <= 1 + eps/2`", bound_at_largest(Rational(1, 2), false)},
           {"`2A <= 1`", bound_at_largest(0, false)},
           {"`2A >= 1 + eps`", bound_at_largest(1, true)}}};
}

}  // namespace steadyslide::proofs_checks
