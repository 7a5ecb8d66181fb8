#include "enclosure/number/ball.hpp"

#include <acb.h>
#include <arb_hypgeom.h>
#include <flint/fmpq.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>

#include "model/invalid_data.hpp"

namespace steadyslide::enclosure {
namespace {

/// True if the text is four hexadecimal integers with single spaces: mantissa and exponent of the midpoint, mantissa
/// and exponent of the radius. The radius' mantissa has up to 30 bits and no sign. Exponents fit into a word; the
/// exponent of 0 is 0.
bool is_four_numbers(std::string_view text) {
  bool zero = false;
  for (int k = 0; k < 4; ++k) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if ((end == text.size()) != (k == 3)) return false;
    std::string_view number = text.substr(0, end);
    if (k != 2 && number.starts_with('-')) number.remove_prefix(1);
    if (number.empty() || number.find_first_not_of("0123456789abcdef") != std::string_view::npos) return false;
    if (k != 0 && number.size() > (k == 2 ? 8 : 14)) return false;
    if (k == 2 && number.size() == 8 && number[0] > '3') return false;
    if (k % 2 == 1 && zero && number != "0") return false;
    zero = number == "0";
    if (k < 3) text.remove_prefix(end + 1);
  }
  return true;
}

/// FLINT keeps memory for each thread. It is given back when the thread ends.
struct ThreadMemory {
  ~ThreadMemory() { flint_cleanup(); }
};

Bits larger(const Ball& a, const Ball& b) { return std::max(a.bits(), b.bits()); }

using Unary = void (*)(arb_t, const arb_t, slong);
using Binary = void (*)(arb_t, const arb_t, const arb_t, slong);

Ball applied(Unary function, const Ball& x) { return made_by(function, x.bits(), x.get(), x.bits()); }
Ball applied(Binary function, const Ball& x, const Ball& y) {
  const Bits bits = larger(x, y);
  return made_by(function, bits, x.get(), y.get(), bits);
}

/// Returns x^p for x > 0, by one logarithm and one exponential.
Ball positive_power(const Ball& x, const Ball& p) { return exp(p * log(x)); }

}  // namespace

Bits bits_for(int digits) { return static_cast<Bits>(std::ceil(digits * 3.3219280948873626)) + 64; }

Ball::Ball(int value, Bits bits) : bits_(bits) {
  arb_init(value_);
  arb_set_si(value_, value);
}

Ball::Ball(const Rational& value, Bits bits) : Ball(0, bits) {
  // Here, because every calculation converts its data.
  thread_local const ThreadMemory memory;
  fmpq_t exact;
  fmpq_init(exact);
  fmpq_set_mpq(exact, value.backend().data());
  arb_set_fmpq(value_, exact, bits);
  fmpq_clear(exact);
}

Ball Ball::exactly(double value, Bits bits) {
  return std::isfinite(value) ? made_by(arb_set_d, bits, value) : unknown(bits);
}

Ball::Ball(const Exponent& exponent, Bits bits) : Ball(0, bits) {
  const Exponent::Reduced reduced = exponent.reduced();
  *this = Ball(Rational(reduced.halves) / 2, bits) + atan(Ball(reduced.slope, bits)) / pi(bits);
}

Ball Ball::hull(const Ball& a, const Ball& b) { return applied(arb_union, a, b); }

Ball Ball::around(const Ball& centre, const Ball& radius) {
  return plus_or_minus(centre.midpoint().at(larger(centre, radius)), radius);
}

Ball Ball::plus_or_minus(const Ball& ball, const Ball& error) {
  Ball result(ball);
  arb_add_error(result.value_, error.value_);
  return result;
}

Ball Ball::pi(Bits bits) { return made_by(arb_const_pi, bits, bits); }

Ball Ball::unknown(Bits bits) { return made_by(arb_indeterminate, bits); }

Ball Ball::infinity(int sign, Bits bits) { return made_by(sign < 0 ? arb_neg_inf : arb_pos_inf, bits); }

Ball::Ball(const Ball& other) : bits_(other.bits_) {
  arb_init(value_);
  arb_set(value_, other.value_);
}

Ball::Ball(Ball&& other) noexcept : bits_(other.bits_) {
  arb_init(value_);
  arb_swap(value_, other.value_);
}

Ball Ball::at(Bits bits) const {
  Ball result(*this);
  result.bits_ = bits;
  return result;
}

Ball Ball::operator-() const { return made_by(arb_neg, bits_, value_); }

bool Ball::contains(const Rational& value) const {
  fmpq_t exact;
  fmpq_init(exact);
  fmpq_set_mpq(exact, value.backend().data());
  const bool contained = is_finite() && arb_contains_fmpq(value_, exact) != 0;
  fmpq_clear(exact);
  return contained;
}

bool Ball::contains_inside(const Ball& other) const {
  return is_finite() && other.is_finite() && arb_contains_interior(value_, other.value_) != 0;
}

bool Ball::overlaps(const Ball& other) const {
  return is_finite() && other.is_finite() && arb_overlaps(value_, other.value_) != 0;
}

Ball Ball::midpoint() const { return made_by(arb_get_mid_arb, bits_, value_); }

Ball Ball::radius() const { return made_by(arb_get_rad_arb, bits_, value_); }

Ball Ball::lower() const {
  Ball result(0, bits_);
  arb_get_lbound_arf(arb_midref(result.value_), value_, bits_);
  return result;
}

Ball Ball::upper() const {
  Ball result(0, bits_);
  arb_get_ubound_arf(arb_midref(result.value_), value_, bits_);
  return result;
}

Ball Ball::intersection(const Ball& other) const {
  if (!other.is_finite()) return *this;
  if (!is_finite()) return other;
  Ball result(0, larger(*this, other));
  if (!arb_intersection(result.value_, value_, other.value_, result.bits_)) return unknown(result.bits_);
  return result;
}

double Ball::to_double() const { return arf_get_d(arb_midref(value_), ARF_RND_NEAR); }

std::string Ball::to_string(int digits) const {
  const std::unique_ptr<char, void (*)(void*)> text(arb_get_str(value_, digits, 0), flint_free);
  return text.get();
}

std::string Ball::dump() const {
  const std::unique_ptr<char, void (*)(void*)> text(arb_dump_str(value_), flint_free);
  return text.get();
}

Ball Ball::load(std::string_view text, Bits bits) {
  // arb_load_str (Arb 2.23) joins a fifth number to the fourth, drops the sign of a radius, and ends the process if the
  // radius has too many bits. So the text must be equal to what Arb would write.
  const std::string copy(text);
  Ball result(0, bits);
  if (!is_four_numbers(text) || arb_load_str(result.value_, copy.c_str()) != 0 || result.dump() != text) {
    throw InvalidData("", "not a ball", "four integers in Arb's notation", copy);
  }
  return result;
}

Ball abs(const Ball& x) { return made_by(arb_abs, x.bits(), x.get()); }
Ball sqrt(const Ball& x) { return applied(arb_sqrt, x); }
Ball exp(const Ball& x) { return applied(arb_exp, x); }
Ball expm1(const Ball& x) { return applied(arb_expm1, x); }
Ball log(const Ball& x) { return applied(arb_log, x); }
Ball sin(const Ball& x) { return applied(arb_sin, x); }
Ball cos(const Ball& x) { return applied(arb_cos, x); }
Ball atan(const Ball& x) { return applied(arb_atan, x); }
Ball gamma(const Ball& x) { return applied(arb_gamma, x); }
Ball min(const Ball& a, const Ball& b) { return applied(arb_min, a, b); }
Ball max(const Ball& a, const Ball& b) { return applied(arb_max, a, b); }

bool all_finite(const std::vector<Ball>& balls) {
  return std::all_of(balls.begin(), balls.end(), [](const Ball& ball) { return ball.is_finite(); });
}

Ball power(const Ball& x, int n) {
  if (n < 0) return Ball(1) / power(x, -n);
  return made_by(arb_pow_ui, x.bits(), x.get(), static_cast<ulong>(n), x.bits());
}

Ball power(const Ball& x, const Ball& p) {
  const Bits bits = larger(x, p);
  if (!x.is_finite() || !p.is_finite() || x.is_negative()) return Ball::unknown(bits);
  // Arb's logarithm and exponential are good for a thin ball. For a wide ball the values at its ends are closer.
  if (arb_rel_accuracy_bits(x.get()) > 8 && x.is_positive()) return positive_power(x, p);
  const Ball low = x.lower();
  const Ball high = x.upper();
  if (low.is_positive()) return Ball::hull(positive_power(low, p), positive_power(high, p));
  if (!p.is_positive()) return Ball::unknown(bits);
  // x >= 0 by definition; a part below 0 is rounding.
  return Ball::hull(Ball(0, bits), high.is_positive() ? positive_power(high, p) : Ball(0, bits));
}

double rough_log2(const Ball& x) {
  mag_t size;
  mag_init(size);
  arb_get_mag(size, x.get());
  const double result = mag_get_d_log2_approx(size);
  mag_clear(size);
  return result;
}

std::ostream& operator<<(std::ostream& out, const Ball& ball) { return out << ball.to_string(20); }

}  // namespace steadyslide::enclosure
