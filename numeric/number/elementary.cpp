#include "numeric/number/elementary.hpp"

#include <arb.h>

#include <algorithm>

namespace steadyslide::numeric::elementary {
namespace {

constexpr slong guard_bits = 16;
constexpr slong bits_beyond_rounding = 8;

/// A ball that frees its memory.
class Scratch {
 public:
  explicit Scratch(mpfr_srcptr x) {
    arb_init(ball_);
    arf_set_mpfr(arb_midref(ball_), x);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { arb_clear(ball_); }

  operator arb_ptr() { return ball_; }  // NOLINT(google-explicit-constructor): the class is a ball

  /// Sets `result` to the midpoint and returns true, if the ball determines all bits of `result`.
  bool rounded_to(mpfr_ptr result) const {
    if (!arb_is_finite(ball_) || arb_rel_accuracy_bits(ball_) < mpfr_get_prec(result) + bits_beyond_rounding) {
      return false;
    }
    arf_get_mpfr(result, arb_midref(ball_), MPFR_RNDN);
    return true;
  }

 private:
  arb_t ball_;
};

/// MPFR's exponents end at 2^30. MPFR computes all numbers close to this limit.
constexpr mpfr_exp_t largest_exponent = 29;

slong bits_of(mpfr_exp_t exponent) {
  slong bits = 0;
  for (mpfr_exp_t rest = std::abs(exponent); rest > 0; rest /= 2) ++bits;
  return bits;
}

}  // namespace

void log(mpfr_ptr result, mpfr_srcptr x) {
  if (mpfr_regular_p(x) != 0 && mpfr_sgn(x) > 0) {
    Scratch ball(x);
    arb_log(ball, ball, mpfr_get_prec(result) + guard_bits);
    if (ball.rounded_to(result)) return;
  }
  mpfr_log(result, x, MPFR_RNDN);
}

void exp(mpfr_ptr result, mpfr_srcptr x) {
  if (mpfr_regular_p(x) != 0 && mpfr_get_exp(x) <= largest_exponent) {
    Scratch ball(x);
    arb_exp(ball, ball, mpfr_get_prec(result) + guard_bits);
    if (ball.rounded_to(result)) return;
  }
  mpfr_exp(result, x, MPFR_RNDN);
}

void pow(mpfr_ptr result, mpfr_srcptr base, mpfr_srcptr exponent) {
  // MPFR computes integer powers, which may be exact.
  const bool whole = mpfr_integer_p(exponent) != 0;
  const bool plain = !whole && mpfr_regular_p(base) != 0 && mpfr_sgn(base) > 0 && mpfr_regular_p(exponent) != 0;
  // The number of bits before the point in y log x.
  const slong before_point = plain ? std::max<slong>(0, mpfr_get_exp(exponent) + bits_of(mpfr_get_exp(base))) : 0;
  if (plain && before_point <= largest_exponent) {
    // e^(y log x) loses these bits.
    const slong bits = mpfr_get_prec(result) + guard_bits + before_point;
    Scratch ball(base);
    Scratch y(exponent);
    arb_log(ball, ball, bits);
    arb_mul(ball, ball, y, bits);
    arb_exp(ball, ball, bits);
    if (ball.rounded_to(result)) return;
  }
  // An odd power of 0 has the sign of the zero.
  if (mpfr_zero_p(base) != 0 && whole && mpfr_sgn(exponent) > 0 && mpfr_fits_ulong_p(exponent, MPFR_RNDN) != 0 &&
      mpfr_get_ui(exponent, MPFR_RNDN) % 2 == 1) {
    mpfr_set(result, base, MPFR_RNDN);
    return;
  }
  mpfr_pow(result, base, exponent, MPFR_RNDN);
}

struct PowerProduct::Balls {
  slong bits;
  arb_t sum, logarithm, exponent, power;
  mpfr_t beyond;  // the powers of numbers that are not regular
  bool has_beyond = false;

  explicit Balls(mpfr_prec_t of) : bits(of) {
    for (arb_ptr ball : {sum, logarithm, exponent, power}) arb_init(ball);
    mpfr_init2(beyond, of);
  }
  Balls(const Balls&) = delete;
  Balls& operator=(const Balls&) = delete;
  ~Balls() {
    for (arb_ptr ball : {sum, logarithm, exponent, power}) arb_clear(ball);
    mpfr_clear(beyond);
  }
};

PowerProduct::PowerProduct(mpfr_prec_t bits) : balls_(std::make_unique<Balls>(bits)) {}
PowerProduct::~PowerProduct() = default;

void PowerProduct::set_one() {
  arb_zero(balls_->sum);
  balls_->has_beyond = false;
}

void PowerProduct::multiply(mpfr_srcptr base, mpfr_srcptr exponent) {
  Balls& b = *balls_;
  if (mpfr_regular_p(base) == 0) {
    if (!b.has_beyond) mpfr_set_ui(b.beyond, 1, MPFR_RNDN);
    b.has_beyond = true;
    mpfr_t one;
    mpfr_init2(one, b.bits);
    mpfr_pow(one, base, exponent, MPFR_RNDN);
    mpfr_mul(b.beyond, b.beyond, one, MPFR_RNDN);
    mpfr_clear(one);
    return;
  }
  // Only the midpoint is set here. The radius must be 0, because it would count as an error of the number.
  arf_set_mpfr(arb_midref(b.logarithm), base);
  mag_zero(arb_radref(b.logarithm));
  arb_log(b.logarithm, b.logarithm, b.bits);
  arf_set_mpfr(arb_midref(b.exponent), exponent);
  arb_addmul(b.sum, b.logarithm, b.exponent, b.bits);
}

void PowerProduct::value(mpfr_ptr result) const {
  Balls& b = *balls_;
  if (arf_cmpabs_2exp_si(arb_midref(b.sum), largest_exponent) < 0) {
    arb_exp(b.power, b.sum, b.bits);
    arf_get_mpfr(result, arb_midref(b.power), MPFR_RNDN);
  } else {
    arf_get_mpfr(result, arb_midref(b.sum), MPFR_RNDN);
    mpfr_exp(result, result, MPFR_RNDN);
  }
  if (b.has_beyond) mpfr_mul(result, result, b.beyond, MPFR_RNDN);
}

}  // namespace steadyslide::numeric::elementary
