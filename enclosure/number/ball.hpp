#pragma once
// A ball: a real number known to lie within a radius of a midpoint [mid - rad, mid + rad] (Arb's arb_t), with the
// precision in bits at which results are rounded. Every operation returns a ball that contains the results for all
// numbers in its operands, at the larger one of their precisions. There is no global state.
//
// What lies outside an operation's domain (division by a ball with 0 in it, log of one that reaches 0) gives a ball
// that is not finite: it contains everything, and no comparison with it is decided.

#include <arb.h>

#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/exponent.hpp"
#include "model/rational.hpp"

namespace steadyslide::enclosure {

using Bits = slong;

/// The bits that hold `digits` decimal digits, and some to spare for the sums of a computation.
Bits bits_for(int digits);

class Ball {
 public:
  /// Exact. By itself it is rounded at 64 bits; beside a ball of more, at theirs.
  Ball(int value = 0) : Ball(value, exact_) {}  // NOLINT(google-explicit-constructor): numbers are balls
  Ball(int value, Bits bits);
  Ball(const Rational& value, Bits bits);
  /// The double itself, exactly. Not finite where it is not.
  static Ball exactly(double value, Bits bits);
  /// halves/2 + arctan(slope)/pi: no cancellation near zero.
  Ball(const Exponent& exponent, Bits bits);
  /// Every number between the two balls, theirs included.
  static Ball hull(const Ball& a, const Ball& b);
  /// [mid - radius, mid + radius] around the ball's midpoint.
  static Ball around(const Ball& centre, const Ball& radius);
  /// Every number within the distance `error` of one in the ball.
  static Ball plus_or_minus(const Ball& ball, const Ball& error);
  static Ball pi(Bits bits);
  /// What contains everything.
  static Ball unknown(Bits bits);
  /// Infinity itself, with the sign of `sign`: a limit. It is not finite.
  static Ball infinity(int sign, Bits bits);
  bool is_infinity() const { return arf_is_inf(arb_midref(value_)) && mag_is_zero(arb_radref(value_)); }

  Ball(const Ball& other);
  Ball(Ball&& other) noexcept;
  Ball& operator=(Ball other) noexcept {
    arb_swap(value_, other.value_);
    bits_ = other.bits_;
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  Bits bits() const { return bits_; }
  /// The same ball, rounded from now on at another precision.
  Ball at(Bits bits) const;

  Ball& operator+=(const Ball& other) { return combine(arb_add, other); }
  Ball& operator-=(const Ball& other) { return combine(arb_sub, other); }
  Ball& operator*=(const Ball& other) { return combine(arb_mul, other); }
  Ball& operator/=(const Ball& other) { return combine(arb_div, other); }
  Ball operator-() const;
  friend Ball operator+(Ball a, const Ball& b) { return std::move(a += b); }
  friend Ball operator-(Ball a, const Ball& b) { return std::move(a -= b); }
  friend Ball operator*(Ball a, const Ball& b) { return std::move(a *= b); }
  friend Ball operator/(Ball a, const Ball& b) { return std::move(a /= b); }

  // Decided for every number in the balls: false means that they are not, or that it is not known.
  friend bool operator<(const Ball& a, const Ball& b) { return arb_lt(a.value_, b.value_) != 0; }
  friend bool operator>(const Ball& a, const Ball& b) { return b < a; }
  friend bool operator<=(const Ball& a, const Ball& b) { return arb_le(a.value_, b.value_) != 0; }
  friend bool operator>=(const Ball& a, const Ball& b) { return b <= a; }
  bool is_positive() const { return arb_is_positive(value_) != 0; }
  bool is_negative() const { return arb_is_negative(value_) != 0; }
  /// 0 exactly.
  bool is_zero() const { return arb_is_zero(value_) != 0; }
  bool is_finite() const { return arb_is_finite(value_) != 0; }
  /// False for what is not finite, unlike Arb's own test.
  bool contains(const Ball& other) const {
    return is_finite() && other.is_finite() && arb_contains(value_, other.value_);
  }
  bool contains(const Rational& value) const;
  bool contains_zero() const { return arb_contains_zero(value_) != 0; }
  /// Strictly inside, with a distance from both ends.
  bool contains_inside(const Ball& other) const;
  /// Is there a number in both? False where one of them is not finite.
  bool overlaps(const Ball& other) const;

  Ball midpoint() const;
  Ball radius() const;
  /// The ends of the ball as exact numbers, rounded outwards.
  Ball lower() const;
  Ball upper() const;
  /// What both contain; the ball itself where the other one is not finite, unknown() where they have nothing in common.
  Ball intersection(const Ball& other) const;
  /// The midpoint as the nearest double.
  double to_double() const;

  /// The digits that are proved, "0.3183098861837906715377675267", with "+/- radius" where fewer than asked for.
  std::string to_string(int digits) const;
  /// Arb's own notation, exact: mantissas and exponents in hexadecimal.
  std::string dump() const;
  /// Reads back what dump() wrote of a finite ball. Throws InvalidData for anything else.
  static Ball load(std::string_view text, Bits bits);

  const arb_struct* get() const { return value_; }
  arb_struct* get() { return value_; }

 private:
  static constexpr Bits exact_ = 64;
  /// The ball becomes what Arb's operation makes of it and the other one.
  template <class Operation>
  Ball& combine(Operation operation, const Ball& other) {
    bits_ = bits_ < other.bits_ ? other.bits_ : bits_;
    operation(value_, value_, other.value_, bits_);
    return *this;
  }

  arb_t value_;
  Bits bits_;
};

/// Calls a function of Arb and returns its result. The arguments include the number of bits if the function rounds.
template <class Function, class... Arguments>
Ball made_by(Function function, Bits bits, const Arguments&... arguments) {
  Ball result(0, bits);
  function(result.get(), arguments...);
  return result;
}

Ball abs(const Ball& x);
Ball sqrt(const Ball& x);
Ball exp(const Ball& x);
/// e^x - 1.
Ball expm1(const Ball& x);
Ball log(const Ball& x);
Ball sin(const Ball& x);
Ball cos(const Ball& x);
Ball atan(const Ball& x);
bool all_finite(const std::vector<Ball>& balls);

Ball min(const Ball& a, const Ball& b);
Ball max(const Ball& a, const Ball& b);
Ball gamma(const Ball& x);
/// x^n.
Ball power(const Ball& x, int n);
/// x^p for x >= 0. Where x reaches 0 or is wide, from its ends, at which the power is monotone in x and in p; not
/// finite where x reaches 0 and p reaches 0 or a negative number.
Ball power(const Ball& x, const Ball& p);

/// log2 of the largest |x| in the ball to two digits or so: for choices, not for bounds. -inf for 0.
double rough_log2(const Ball& x);

/// "[0.3183098861837907 +/- 1e-17]"
std::ostream& operator<<(std::ostream& out, const Ball& ball);

}  // namespace steadyslide::enclosure
