#include "symbolic/cln/decimal.hpp"

#include <stdexcept>

namespace steadyslide::symbolic {
namespace {

Rational power_of_ten(int exponent) {
  const Integer power =
      boost::multiprecision::pow(Integer(10), static_cast<unsigned>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? Rational(1, power) : Rational(power);
}

/// Returns e with 10^e <= value < 10^(e+1), for value > 0.
int decimal_exponent(const Rational& value) {
  const auto length = [](const Integer& n) { return static_cast<int>(n.str().size()); };
  // The numbers of digits leave two possible values.
  const int upper = length(boost::multiprecision::numerator(value)) - length(boost::multiprecision::denominator(value));
  return value < power_of_ten(upper) ? upper - 1 : upper;
}

std::string written(std::string digits, int exponent) {
  const int count = static_cast<int>(digits.size());
  if (exponent < -5 || exponent >= count) {
    if (count > 1) digits.insert(1, ".");
    return digits + "e" + std::to_string(exponent);
  }
  if (exponent < 0) return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
  if (exponent + 1 < count) return digits.insert(static_cast<std::size_t>(exponent + 1), ".");
  return digits;
}

}  // namespace

Decimal rounded(const Rational& value, int digits) {
  if (digits < 1) throw std::domain_error("rounded: at least one digit; " + std::to_string(digits));
  if (value == 0) return {0, "0"};
  const Rational size = abs(value);
  int exponent = decimal_exponent(size);
  const Rational scaled = size * power_of_ten(digits - 1 - exponent) + Rational(1, 2);
  Integer mantissa = boost::multiprecision::numerator(scaled) / boost::multiprecision::denominator(scaled);
  if (mantissa == boost::multiprecision::pow(Integer(10), static_cast<unsigned>(digits))) {
    mantissa /= 10;
    ++exponent;
  }
  const Rational result = mantissa * power_of_ten(exponent - digits + 1);
  const std::string text = written(mantissa.str(), exponent);
  return value < 0 ? Decimal{-result, "-" + text} : Decimal{result, text};
}

}  // namespace steadyslide::symbolic
