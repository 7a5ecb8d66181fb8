#include "model/rational.hpp"

#include <algorithm>
#include <cctype>

#include "model/invalid_data.hpp"

namespace steadyslide {
namespace {

constexpr std::string_view number_rule = "a number is written like 2, -0.25, 1e-3 or 1/3";

/// Returns the text in quotes, shortened and without control characters, for one line of an error message.
std::string excerpt(std::string_view text) {
  std::string shown;
  for (const char c : text.substr(0, 40)) shown += std::isprint(static_cast<unsigned char>(c)) != 0 ? c : '?';
  return "'" + shown + (text.size() > 40 ? "...'" : "'");
}

[[noreturn]] void not_a_number(std::string_view text) {
  throw InvalidData("", "not a number", std::string(number_rule), excerpt(text));
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

Integer power_of_ten(unsigned exponent) { return boost::multiprecision::pow(Integer(10), exponent); }

/// Reads one decimal number. `whole` is the complete text that contains it; the error message shows that.
Rational parse_decimal(std::string_view text, std::string_view whole) {
  std::size_t i = 0;
  bool negative = false;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) negative = text[i++] == '-';
  std::string digits;
  int scale = 0;
  for (; i < text.size() && is_digit(text[i]); ++i) digits += text[i];
  if (i < text.size() && text[i] == '.') {
    for (++i; i < text.size() && is_digit(text[i]); ++i, --scale) digits += text[i];
  }
  if (digits.empty()) not_a_number(whole);
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    bool negative_exponent = false;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) negative_exponent = text[i++] == '-';
    if (i == text.size()) not_a_number(whole);
    int exponent = 0;
    for (; i < text.size() && is_digit(text[i]); ++i) exponent = std::min(10 * exponent + (text[i] - '0'), 100000);
    if (exponent > max_decimal_exponent) {
      throw InvalidData("", "exponent out of range",
                        "a decimal exponent is at most " + std::to_string(max_decimal_exponent) + " in size",
                        excerpt(whole));
    }
    scale += negative_exponent ? -exponent : exponent;
  }
  if (i != text.size()) not_a_number(whole);

  // GMP would read a leading zero as an octal prefix.
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  Integer mantissa(digits);
  if (negative) mantissa = -mantissa;
  return scale >= 0 ? Rational(mantissa * power_of_ten(static_cast<unsigned>(scale)))
                    : Rational(mantissa, power_of_ten(static_cast<unsigned>(-scale)));
}

}  // namespace

Rational parse_rational(std::string_view text) {
  if (text.size() > max_number_length) {
    throw InvalidData("", "number too long",
                      "a number has at most " + std::to_string(max_number_length) + " characters",
                      std::to_string(text.size()) + " characters");
  }
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return parse_decimal(text, text);
  const Rational denominator = parse_decimal(text.substr(slash + 1), text);
  if (denominator == 0) {
    throw InvalidData("", "division by zero", "the denominator of a number is not zero", excerpt(text));
  }
  return parse_decimal(text.substr(0, slash), text) / denominator;
}

std::string to_string(const Rational& value) {
  const Integer numerator = boost::multiprecision::numerator(value);
  Integer rest = boost::multiprecision::denominator(value);
  if (rest == 1) return numerator.str();
  int twos = 0;
  int fives = 0;
  for (; rest % 2 == 0; ++twos) rest /= 2;
  for (; rest % 5 == 0; ++fives) rest /= 5;
  const int places = std::max(twos, fives);
  if (rest != 1 || places > 30) return value.str();
  const Integer scaled =
      numerator * power_of_ten(static_cast<unsigned>(places)) / boost::multiprecision::denominator(value);
  std::string digits = boost::multiprecision::abs(scaled).str();
  const auto width = static_cast<std::size_t>(places) + 1;
  if (digits.size() < width) digits.insert(0, width - digits.size(), '0');
  digits.insert(digits.size() - static_cast<std::size_t>(places), ".");
  return numerator < 0 ? "-" + digits : digits;
}

}  // namespace steadyslide
