#pragma once
// A ball: a real number in [mid - rad, mid + rad] (Arb's arb_t), with the precision in bits at which results are
// rounded. Every operation returns a ball that contains the results for all numbers in its operands, at the larger one
// of their precisions. There is no global state.
//
// An argument outside an operation's domain (division by a ball that contains 0, log of a ball that reaches 0) gives a
// ball that is not finite: it contains all numbers, and no comparison with it is decided.

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

/// Returns the bits for `digits` decimal digits, and some spare bits for the sums of a computation.
Bits bits_for(int digits);

class Ball {
 public:
  /// An exact integer. Results with only such balls are rounded at 64 bits; with a ball of higher precision, at that
  /// precision.
  Ball(int value = 0) : Ball(value, exact_) {}  // NOLINT(google-explicit-constructor): numbers are balls
  Ball(int value, Bits bits);
  Ball(const Rational& value, Bits bits);
  /// Returns the exact double; not finite if the double is not.
  static Ball exactly(double value, Bits bits);
  /// The value halves/2 + arctan(slope)/pi, without cancellation near zero.
  Ball(const Exponent& exponent, Bits bits);
  /// Returns a ball with all numbers of both balls and between them.
  static Ball hull(const Ball& a, const Ball& b);
  /// Returns [mid - radius, mid + radius] around the ball's midpoint.
  static Ball around(const Ball& centre, const Ball& radius);
  /// Returns a ball with every number within the distance `error` of a number in the ball.
  static Ball plus_or_minus(const Ball& ball, const Ball& error);
  static Ball pi(Bits bits);
  /// Returns the ball that contains all numbers.
  static Ball unknown(Bits bits);
  /// Returns infinity with the sign of `sign`, as a limit. It is not finite.
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
  /// Returns the same ball with another precision.
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

  // Comparisons are true if they hold for all numbers in the balls. False means that they do not hold, or are
  // undecided.
  friend bool operator<(const Ball& a, const Ball& b) { return arb_lt(a.value_, b.value_) != 0; }
  friend bool operator>(const Ball& a, const Ball& b) { return b < a; }
  friend bool operator<=(const Ball& a, const Ball& b) { return arb_le(a.value_, b.value_) != 0; }
  friend bool operator>=(const Ball& a, const Ball& b) { return b <= a; }
  bool is_positive() const { return arb_is_positive(value_) != 0; }
  bool is_negative() const { return arb_is_negative(value_) != 0; }
  /// True if the ball is exactly 0.
  bool is_zero() const { return arb_is_zero(value_) != 0; }
  bool is_finite() const { return arb_is_finite(value_) != 0; }
  /// False if a ball is not finite, unlike Arb's own test.
  bool contains(const Ball& other) const {
    return is_finite() && other.is_finite() && arb_contains(value_, other.value_);
  }
  bool contains(const Rational& value) const;
  bool contains_zero() const { return arb_contains_zero(value_) != 0; }
  /// True if `other` is strictly inside, at a distance from both ends.
  bool contains_inside(const Ball& other) const;
  /// True if both balls have a common number. False if one of them is not finite.
  bool overlaps(const Ball& other) const;

  Ball midpoint() const;
  Ball radius() const;
  /// Return the ends of the ball as exact numbers, rounded outwards.
  Ball lower() const;
  Ball upper() const;
  /// Returns the common part of both balls. If the other one is not finite, returns this ball; without a common number,
  /// unknown().
  Ball intersection(const Ball& other) const;
  /// Returns the double nearest to the midpoint.
  double to_double() const;

  /// Returns the proved digits, such as "0.3183098861837906715377675267", with "+/- radius" if they are fewer than
  /// `digits`.
  std::string to_string(int digits) const;
  /// Returns Arb's exact notation: mantissas and exponents in hexadecimal.
  std::string dump() const;
  /// Reads the output of dump() for a finite ball. Throws InvalidData for any other text.
  static Ball load(std::string_view text, Bits bits);

  const arb_struct* get() const { return value_; }
  arb_struct* get() { return value_; }

 private:
  static constexpr Bits exact_ = 64;
  /// Replaces the ball by the result of Arb's operation on it and the other ball.
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
/// Returns e^x - 1.
Ball expm1(const Ball& x);
Ball log(const Ball& x);
Ball sin(const Ball& x);
Ball cos(const Ball& x);
Ball atan(const Ball& x);
bool all_finite(const std::vector<Ball>& balls);

Ball min(const Ball& a, const Ball& b);
Ball max(const Ball& a, const Ball& b);
Ball gamma(const Ball& x);
/// Returns x^n.
Ball power(const Ball& x, int n);
/// Returns x^p for x >= 0. If x reaches 0 or is wide, the result comes from the ends, because the power is monotone in
/// x and in p. Not finite if x reaches 0 and p reaches 0 or a negative number.
Ball power(const Ball& x, const Ball& p);

/// Returns log2 of the largest |x| in the ball to about two digits; -inf for 0. For choices, not for bounds.
double rough_log2(const Ball& x);

/// "[0.3183098861837907 +/- 1e-17]"
std::ostream& operator<<(std::ostream& out, const Ball& ball);

}  // namespace steadyslide::enclosure
