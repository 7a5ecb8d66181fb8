#pragma once
// A real number as an Arb ball: a midpoint and a radius, with the precision of computations with it. A result has the
// lower precision of its two operands; small integers and doubles are exact and take the precision of the other
// operand. A predicate such as is_positive() is true only if it holds for all numbers of the ball; it is never true for
// NaN.

#include <arb.h>

#include <algorithm>
#include <string>
#include <vector>

#include "checker/rational.hpp"

namespace steadyslide::checker {

/// An upper bound of a non-negative number, with 30 bits and any exponent; infinite if there is no bound.
class Bound {
 public:
  Bound() { mag_init(bound_); }
  Bound(const Bound& other) { mag_init_set(bound_, other.bound_); }
  Bound& operator=(const Bound& other) {
    mag_set(bound_, other.bound_);
    return *this;
  }
  ~Bound() { mag_clear(bound_); }
  mag_ptr get() { return bound_; }
  mag_srcptr get() const { return bound_; }

 private:
  mag_t bound_;
};

class Ball {
 public:
  static constexpr slong exact = 1 << 13;

  Ball(int n = 0) : precision_(exact) {
    arb_init(ball_);
    arb_set_si(ball_, n);
  }
  Ball(double x) : Ball() { arb_set_d(ball_, x); }
  Ball(const Bound& x) : Ball() { arf_set_mag(arb_midref(ball_), x.get()); }
  Ball(const Rational& q, slong precision) : Ball() {
    precision_ = precision;
    arb_set_fmpq(ball_, q.get(), precision);
  }
  Ball(const Ball& other) : Ball() {
    precision_ = other.precision_;
    arb_set(ball_, other.ball_);
  }
  Ball(Ball&& other) noexcept : Ball() { swap(other); }
  Ball& operator=(Ball other) noexcept {
    swap(other);
    return *this;
  }
  ~Ball() { arb_clear(ball_); }

  static Ball pi(slong precision) { return made(precision, arb_const_pi, precision); }
  /// Reads the output of arb_dump_str. Returns NaN for any other text, for a ball that is not finite, and for more than
  /// `bits` bits.
  static Ball parse(const std::string& text, slong bits);

  arb_ptr get() { return ball_; }
  arb_srcptr get() const { return ball_; }
  slong precision() const { return precision_; }
  Ball rounded(slong precision) const { return made(precision, arb_set_round, ball_, precision); }

  bool is_zero() const { return arb_is_zero(ball_) != 0; }
  bool is_positive() const { return arb_is_positive(ball_) != 0; }
  bool is_negative() const { return arb_is_negative(ball_) != 0; }
  bool is_finite() const { return arb_is_finite(ball_) != 0; }
  /// True if the interior of this ball contains all of `other`.
  bool contains_inside(const Ball& other) const {
    return is_finite() && other.is_finite() && arb_contains_interior(ball_, other.ball_) != 0;
  }

  // These return exact balls: the centre, the two ends, the radius, the largest absolute value.
  Ball middle() const { return made(precision_, arb_get_mid_arb, ball_); }
  Ball radius() const { return made(precision_, arb_get_rad_arb, ball_); }
  Ball lower() const { return -(-*this).upper(); }
  Ball upper() const {
    Ball result = made(precision_, arb_set, ball_);
    arb_get_ubound_arf(arb_midref(result.ball_), ball_, precision_);
    mag_zero(arb_radref(result.ball_));
    return result;
  }
  Ball size() const {
    const Ball a = upper(), b = (-*this).upper();
    return (a - b).is_negative() ? b : a;
  }
  /// Returns this ball with `error`'s largest absolute value added to its radius.
  Ball widened(const Ball& error) const {
    Ball result = *this;
    arb_add_error(result.ball_, error.ball_);
    return result;
  }
  Bound bound() const {
    Bound result;
    arb_get_mag(result.get(), ball_);
    return result;
  }
  /// Returns, for the centre x, the smallest e with |x| < 2^e; for 0 a very small number.
  slong exponent() const { return std::max<slong>(arf_abs_bound_lt_2exp_si(arb_midref(ball_)), -(slong(1) << 40)); }
  double approximately() const { return arf_get_d(arb_midref(ball_), ARF_RND_NEAR); }
  /// Returns text such as "0.41285 +/- 3.1e-12".
  std::string text(slong digits = 6) const;

  Ball operator-() const { return made(precision_, arb_neg, ball_); }
  friend Ball operator+(const Ball& a, const Ball& b) { return both(arb_add, a, b); }
  friend Ball operator-(const Ball& a, const Ball& b) { return both(arb_sub, a, b); }
  friend Ball operator*(const Ball& a, const Ball& b) { return both(arb_mul, a, b); }
  friend Ball operator/(const Ball& a, const Ball& b) { return both(arb_div, a, b); }
  Ball& operator+=(const Ball& b) { return *this = *this + b; }
  Ball& operator-=(const Ball& b) { return *this = *this - b; }
  Ball& operator*=(const Ball& b) { return *this = *this * b; }
  friend Ball exp(const Ball& x) { return made(x.precision_, arb_exp, x.ball_, x.precision_); }
  friend Ball log(const Ball& x) { return made(x.precision_, arb_log, x.ball_, x.precision_); }
  friend Ball sqrt(const Ball& x) { return made(x.precision_, arb_sqrt, x.ball_, x.precision_); }
  friend Ball cos(const Ball& x) { return made(x.precision_, arb_cos, x.ball_, x.precision_); }
  friend Ball sin(const Ball& x) { return made(x.precision_, arb_sin, x.ball_, x.precision_); }
  friend Ball atan(const Ball& x) { return made(x.precision_, arb_atan, x.ball_, x.precision_); }
  /// Returns x^p for x > 0, 0 for x exactly 0 and p > 0, and NaN otherwise. arb_pow gives NaN for x = 0, or computes
  /// another function if p is an integer.
  friend Ball power(const Ball& x, const Ball& p) { return x.is_zero() && p.is_positive() ? Ball() : exp(p * log(x)); }
  /// Returns a ball that contains both.
  friend Ball hull(const Ball& a, const Ball& b) { return both(arb_union, a, b); }

 private:
  void swap(Ball& other) noexcept {
    arb_swap(ball_, other.ball_);
    std::swap(precision_, other.precision_);
  }
  template <class Operation, class... Arguments>
  static Ball made(slong precision, Operation operation, const Arguments&... arguments) {
    Ball result;
    result.precision_ = precision;
    operation(result.ball_, arguments...);
    return result;
  }
  template <class Operation>
  static Ball both(Operation operation, const Ball& a, const Ball& b) {
    const slong precision = std::min(a.precision_, b.precision_);
    return made(precision, operation, a.ball_, b.ball_, precision);
  }

  arb_t ball_;
  slong precision_;
};

/// Returns sum_k a_k x^k.
inline Ball horner(const std::vector<Ball>& a, const Ball& x) {
  Ball sum;
  for (std::size_t k = a.size(); k-- > 0;) sum = sum * x + a[k];
  return sum;
}

inline std::vector<Ball> balls(const Polynomial& p, slong precision) {
  std::vector<Ball> result;
  for (const Rational& c : p) result.emplace_back(c, precision);
  return result;
}

}  // namespace steadyslide::checker
