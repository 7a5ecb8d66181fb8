#include "enclosure/contact/power_at_point.hpp"

#include <utility>

namespace steadyslide::enclosure {
namespace {

/// (1 - sinc x)/x^2 = 1/6 - x^2/120 + ..., |x| <= pi: an alternating series with decreasing terms.
Ball sinc_defect(const Ball& x) {
  const Bits bits = x.bits();
  const Ball square = x * x;
  const Ball enough = power(Ball(2, bits), -static_cast<int>(bits));
  Ball sum(0, bits);
  Ball term = Ball(1, bits) / Ball(6);
  for (int k = 2; !(abs(term) < enough); ++k) {
    sum += term;
    term *= -square / Ball(2 * k * (2 * k + 1));
  }
  return Ball::plus_or_minus(sum, abs(term));
}

}  // namespace

PowerAtPoint::PowerAtPoint(Ball a, bool is_zero, Ball length)
    : a_(std::move(a)),
      is_zero_(is_zero),
      length_(std::move(length)),
      scale_(1, length_.bits()),
      factor_(1, length_.bits()),
      constant_(0, length_.bits()) {
  if (is_zero_) return;
  const Ball x = Ball::pi(a_.bits()) * a_;
  const Ball defect = sinc_defect(x);
  const Ball sinc = Ball(1) - x * x * defect;
  scale_ = power(length_, a_);
  factor_ = scale_ / sinc;
  constant_ = -Ball::pi(a_.bits()) * x * defect / sinc;
}

Ball PowerAtPoint::analytic_part(const Ball& d) const {
  const Ball ratio = d / length_;
  const Ball largest = abs(ratio).upper();
  if (!(largest * Ball(4) < Ball(3))) return Ball::unknown(d.bits());
  const Ball enough = power(Ball(2, d.bits()), -static_cast<int>(d.bits()));
  Ball series = constant_;
  Ball term = -ratio;
  Ball size = largest;
  int j = 1;
  for (; !(size < enough); ++j) {
    series -= term / (Ball(j, d.bits()) - a_);
    term *= -ratio;
    size *= largest;
  }
  return scale_ * Ball::plus_or_minus(series, size / ((Ball(j, d.bits()) - abs(a_)) * (Ball(1) - largest)));
}

Ball PowerAtPoint::constant() const { return is_zero_ ? log(length_) : Ball(1) / a_; }

Ball PowerAtPoint::at(const Ball& d) const {
  const Ball logarithm = log(length_ / d);
  return is_zero_ ? logarithm : -expm1(-a_ * logarithm) / a_;
}

Ball PowerAtPoint::singular_part(const Ball& d, int m) const {
  const Ball zero(0, d.bits());
  const Ball upper = d.upper();
  if (d.is_positive()) return power(d, m) * Ball::hull(at(d.lower()), at(upper));
  if (m == 0) {
    if (!a_.is_positive()) return Ball::unknown(d.bits());
    return Ball::hull(upper.is_positive() ? at(upper) : Ball(1) / a_, Ball(1) / a_);
  }
  if (!upper.is_positive()) return zero;
  // The derivative with respect to log d is d^m (m E - (d/L)^a). If it is positive at `upper`, the function increases
  // up to `upper`.
  const Ball logarithm = log(length_ / upper);
  const Ball rising = is_zero_ ? logarithm : expm1(a_ * logarithm) / a_;
  const Ball most = Ball(m) * rising > Ball(1)
                        ? at(upper)
                        : max(Ball(1, d.bits()), exp(-a_ * logarithm)) / (is_zero_ ? zero : abs(a_));
  return Ball::hull(zero, power(upper, m) * most);
}

}  // namespace steadyslide::enclosure
