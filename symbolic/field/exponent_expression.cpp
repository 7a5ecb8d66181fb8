#include "symbolic/field/exponent_expression.hpp"

#include <cstdlib>

namespace steadyslide::symbolic {

std::string latex(const Rational& value) {
  const Integer numerator = boost::multiprecision::numerator(value);
  const Integer denominator = boost::multiprecision::denominator(value);
  if (denominator == 1) return numerator.str();
  return std::string(numerator < 0 ? "-" : "") + "\\frac{" + boost::multiprecision::abs(numerator).str() + "}{" +
         denominator.str() + "}";
}

std::string latex(const Exponent& exponent) {
  std::string text;
  if (exponent.offset() != 0 || exponent.angles().empty()) text = latex(exponent.offset());
  for (const Exponent::Angle& angle : exponent.angles()) {
    if (angle.times < 0) {
      text += "-";
    } else if (!text.empty()) {
      text += "+";
    }
    const std::string slope = latex(angle.slope);
    text +=
        "\\frac{" + std::to_string(std::abs(angle.times)) + "}{\\pi}\\arctan" + (slope[0] == '\\' ? "" : " ") + slope;
  }
  return text;
}

}  // namespace steadyslide::symbolic
