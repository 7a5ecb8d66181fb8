#include "library/text/number_format.hpp"

#include <fmt/format.h>
#include <mpfr.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "symbolic/field/exponent_expression.hpp"

namespace steadyslide::library {
namespace {

using std::isinf, std::isnan;

/// +-d.ddd * 10^exponent, the digits without the point.
struct Scientific {
  bool negative = false;
  std::string digits;
  long exponent = 0;
};

Scientific parts(const std::string& text) {
  const std::size_t e = text.find('e');
  Scientific result{text[0] == '-', text.substr(0, e), std::strtol(text.c_str() + e + 1, nullptr, 10)};
  std::erase_if(result.digits, [](char c) { return c == '-' || c == '.'; });
  return result;
}

/// `precision`: the digits minus 1, or nothing for as many digits as identify the double.
template <class... Precision>
Scientific scientific_text(double value, Precision... precision) {
  std::array<char, 160> buffer;
  char* const end = buffer.data() + buffer.size();
  return parts(
      {buffer.data(), std::to_chars(buffer.data(), end, value, std::chars_format::scientific, precision...).ptr});
}

Scientific scientific(double value, int digits) { return scientific_text(value, digits - 1); }

Scientific scientific(mpfr_srcptr value, int digits, mpfr_rnd_t rounding = MPFR_RNDN) {
  std::vector<char> buffer(static_cast<std::size_t>(digits) + 8);
  mpfr_exp_t exponent = 0;
  mpfr_get_str(buffer.data(), &exponent, 10, static_cast<std::size_t>(digits), value, rounding);
  const bool negative = buffer[0] == '-';
  return {negative, buffer.data() + (negative ? 1 : 0), exponent - 1};
}

template <numeric::Real R>
Scientific scientific(const R& value, int digits) {
  return scientific(value.backend().data(), digits);
}

Scientific rounded_up(double value, int digits) {
  mpfr_t exact;
  mpfr_init2(exact, std::numeric_limits<double>::digits);
  mpfr_set_d(exact, value, MPFR_RNDN);
  Scientific result = scientific(exact, digits, MPFR_RNDU);
  mpfr_clear(exact);
  return result;
}

template <numeric::Real R>
Scientific rounded_up(const R& value, int digits) {
  return scientific(value.backend().data(), digits, MPFR_RNDU);
}

/// The exact midpoint of the ball.
class Midpoint {
 public:
  explicit Midpoint(const enclosure::Ball& ball) {
    mpfr_init2(value_, std::max<mpfr_prec_t>(MPFR_PREC_MIN, arf_bits(arb_midref(ball.get()))));
    arf_get_mpfr(value_, arb_midref(ball.get()), MPFR_RNDN);
  }
  Midpoint(const Midpoint&) = delete;
  Midpoint& operator=(const Midpoint&) = delete;
  ~Midpoint() { mpfr_clear(value_); }

  Scientific rounded(int digits, mpfr_rnd_t rounding = MPFR_RNDN) const { return scientific(value_, digits, rounding); }

 private:
  mpfr_t value_;
};

std::string lay_out(const Scientific& number, int digits) {
  std::string mantissa = number.digits;
  mantissa.erase(mantissa.find_last_not_of('0') + 1);
  const auto length = static_cast<long>(mantissa.size());
  std::string text = number.negative ? "-" : "";
  if (number.exponent < -5 || number.exponent >= digits) {
    text += mantissa.substr(0, 1);
    if (length > 1) text += "." + mantissa.substr(1);
    return text + "e" + std::to_string(number.exponent);
  }
  if (number.exponent < 0) {
    return text + "0." + std::string(static_cast<std::size_t>(-number.exponent - 1), '0') + mantissa;
  }
  const auto whole = static_cast<std::size_t>(number.exponent + 1);
  if (length <= number.exponent + 1) return text + mantissa + std::string(whole - mantissa.size(), '0');
  return text + mantissa.substr(0, whole) + "." + mantissa.substr(whole);
}

enclosure::Ball ball_of(const Rational& value, int digits) { return {value, enclosure::bits_for(digits)}; }

/// Returns an upper bound of the distance between the number in the text and every number in the ball.
std::string distance_text(const std::string& text, const enclosure::Ball& ball) {
  enclosure::Ball read(0, ball.bits());
  arb_set_str(read.get(), text.c_str(), ball.bits() + 64);
  return upper_text(abs(read - ball));
}

/// Returns the largest number of digits, at most `digits`, to which rounding gives the same result for every
/// number in the ball; 0 if there is none.
int common_digits(const enclosure::Ball& ball, int digits) {
  if (ball.contains_zero()) return ball.is_zero() ? digits : 0;
  const enclosure::Ball low = ball.lower();
  const enclosure::Ball high = ball.upper();
  const Midpoint from(low);
  const Midpoint to(high);
  constexpr double digits_in_a_bit = 0.30103;
  const double known = digits_in_a_bit * static_cast<double>(arb_rel_accuracy_bits(ball.get())) + 2;
  for (int n = static_cast<int>(std::min<double>(digits, known)); n >= 1; --n) {
    const Scientific a = from.rounded(n);
    const Scientific b = to.rounded(n);
    if (a.digits == b.digits && a.exponent == b.exponent) return n;
  }
  return 0;
}

/// Returns the number nearest to a decimal.
template <numeric::Real R>
R number_of(const std::string& text) {
  if constexpr (std::same_as<R, double>) {
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  } else {
    return R(text);
  }
}

constexpr int error_digits = 2;

std::string size_of(const Scientific& error, int digits) {
  return error.digits.find_first_not_of('0') == std::string::npos ? "0" : lay_out(error, digits);
}

/// "80 +/- 120": a value that does not exceed its error, rounded to the last digit of the error.
template <numeric::Real R>
std::string with_error(const numeric::Estimate<R>& estimate) {
  using std::abs;
  const Scientific error = rounded_up(R(abs(estimate.error)), error_digits);
  const long digits = estimate.value == 0 ? 0 : scientific(estimate.value, 17).exponent - error.exponent + error_digits;
  constexpr int plain = 6;
  const std::string value = digits < 1 ? "0" : lay_out(scientific(estimate.value, static_cast<int>(digits)), plain);
  return fmt::format("{} +/- {}", value, lay_out(rounded_up(error_of_text(value, estimate), error_digits), plain));
}

/// Returns the smallest p with error <= 10^p.
template <numeric::Real R>
long last_place(const R& error) {
  const Scientific e = scientific(error, 17);
  const bool power_of_ten = e.digits.find_last_not_of('0') == 0 && e.digits[0] == '1';
  return power_of_ten ? e.exponent : e.exponent + 1;
}

}  // namespace

template <numeric::Real R>
std::string format_number(const R& value, int digits) {
  if (isnan(value)) return "";
  if (value == 0) return "0";
  if (isinf(value)) return value > 0 ? "inf" : "-inf";
  return lay_out(scientific(value, digits), digits);
}

template <numeric::Real R>
std::string format_number(const numeric::Estimate<R>& estimate, int digits) {
  using std::abs;
  const R& value = estimate.value;
  if (isnan(value) || isinf(value)) return format_number(value, digits);
  const R error = abs(estimate.error);
  if (isnan(error) || isinf(error)) return "";
  if (error == 0) return format_number(value, digits);
  if (error >= abs(value)) return with_error(estimate);
  const long supported = scientific(value, 17).exponent - last_place(error) + 1;
  const long shown = std::clamp<long>(supported, 1, digits);
  return lay_out(scientific(value, static_cast<int>(shown)), digits);
}

template <numeric::Real R>
std::string full_number(const R& value, int digits) {
  const auto nearest = static_cast<double>(value);
  // Below the normal doubles there are fewer bits than digits. A value that is itself a double is still exact.
  const bool stands_for_it = std::isnormal(nearest) || (nearest != 0 && value == R(nearest));
  return digits == 16 && stands_for_it && std::isfinite(nearest) ? lay_out(scientific_text(nearest), digits)
                                                                 : format_number(value, digits);
}

template <numeric::Real R>
R error_of_text(const std::string& text, const numeric::Estimate<R>& estimate) {
  using std::abs;
  return abs(estimate.error) + abs(number_of<R>(text) - estimate.value);
}

std::string full_number(const Rational& value, int digits) { return number_text(ball_of(value, digits), digits).value; }

std::string upper_text(const enclosure::Ball& ball, int digits) {
  const enclosure::Ball upper = ball.upper();
  return upper.is_zero() ? "0" : lay_out(Midpoint(upper).rounded(digits, MPFR_RNDU), digits);
}

std::string lower_text(const enclosure::Ball& ball, int digits) {
  const enclosure::Ball lower = ball.lower();
  return lower.is_zero() ? "0" : lay_out(Midpoint(lower).rounded(digits, MPFR_RNDD), digits);
}

NumberText number_text(const enclosure::Ball& ball, int digits) {
  if (ball.is_infinity()) {
    const std::string text = ball.is_positive() ? "inf" : "-inf";
    return {text, text, "0", true};
  }
  if (!ball.is_finite()) return {};
  if (ball.is_zero()) return {"0", "0", "0", true};
  NumberText text;
  text.proved = true;
  const enclosure::Ball middle = ball.midpoint();
  const double nearest = middle.to_double();
  const bool as_double = digits == 16 && std::isnormal(nearest);
  if (as_double) {
    text.value = full_number(nearest, digits);
  } else {
    text.value = middle.is_zero() ? "0" : lay_out(Midpoint(middle).rounded(digits), digits);
  }
  text.error = distance_text(text.value, ball);
  const int common = common_digits(ball, digits);
  text.shown =
      common > 0 ? lay_out(Midpoint(middle).rounded(common), digits) : fmt::format("{} +/- {}", text.value, text.error);
  return text;
}

template <numeric::Real R>
NumberText number_text(const numeric::Estimate<R>& estimate, int digits) {
  NumberText text;
  text.shown = format_number(estimate, digits);
  if (text.shown.empty()) return text;
  text.value = full_number(estimate.value, digits);
  const int few = std::min(error_digits, digits);
  text.error = isinf(estimate.value) ? "0" : size_of(rounded_up(error_of_text(text.value, estimate), few), few);
  return text;
}

template <numeric::Real R>
std::string size_text(const R& value, int digits) {
  using std::abs;
  return format_number(R(abs(value)), std::min(error_digits, digits));
}

std::string format_number(const Rational& value, int digits) {
  if (value == 0) return "0";
  return lay_out(Midpoint(ball_of(value, digits)).rounded(digits), digits);
}

std::string exact_text(const Rational& value) {
  std::string text = to_string(value);
  if (text.size() <= 60) return text;
  // Writes a decimal if the value is one: digits * 10^-places.
  Integer rest = boost::multiprecision::denominator(value);
  int twos = 0;
  int fives = 0;
  for (; rest % 2 == 0; ++twos) rest /= 2;
  for (; rest % 5 == 0; ++fives) rest /= 5;
  if (rest != 1) return text;
  const int places = std::max(twos, fives);
  const Integer power = boost::multiprecision::pow(Integer(10), static_cast<unsigned>(places));
  std::string digits = boost::multiprecision::numerator(Rational(value * power)).str();
  const std::size_t kept = digits.find_last_not_of('0') + 1;
  const long exponent = static_cast<long>(digits.size() - kept) - places;
  digits.erase(kept);
  if (exponent != 0) digits += "e" + std::to_string(exponent);
  return digits.size() < text.size() ? digits : text;
}

std::string format_exponent(const Exponent& exponent, int digits) {
  const enclosure::Ball ball(exponent, enclosure::bits_for(digits));
  return ball.is_zero() ? "0" : lay_out(Midpoint(ball).rounded(digits), digits);
}

std::string stress_intensity_unit(const Exponent& exponent) {
  return fmt::format("F/L^({})", to_string(exponent + Exponent(2)));
}

NumberText proved_exponent(const std::optional<Exponent>& exponent, int digits) {
  if (!exponent) return {"log", "log", "", true};
  return number_text(enclosure::Ball(*exponent, enclosure::bits_for(digits)), digits);
}

ExponentText exponent_text(const std::optional<Exponent>& exponent, int digits) {
  if (!exponent) return {"log", "log", "\\log"};
  return {format_exponent(*exponent, digits), to_string(*exponent), symbolic::latex(*exponent)};
}

#define STEADYSLIDE_NUMBERS_AS_TEXT(R)                                       \
  template std::string format_number(const R&, int);                         \
  template std::string format_number(const numeric::Estimate<R>&, int);      \
  template std::string full_number(const R&, int);                           \
  template R error_of_text(const std::string&, const numeric::Estimate<R>&); \
  template NumberText number_text(const numeric::Estimate<R>&, int);         \
  template std::string size_text(const R&, int)
STEADYSLIDE_NUMBERS_AS_TEXT(double);
STEADYSLIDE_NUMBERS_AS_TEXT(numeric::Real50);
STEADYSLIDE_NUMBERS_AS_TEXT(numeric::Real100);

}  // namespace steadyslide::library
