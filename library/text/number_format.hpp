#pragma once
// Numbers as text: N significant digits, rounded to nearest, without zeros at the end. The text is plain if the decimal
// exponent lies in [-5, N[, otherwise like 1.5e-30. Zero is 0, infinities are inf and -inf, NaN is an empty text.

#include <optional>
#include <string>

#include "enclosure/number/ball.hpp"
#include "model/exponent.hpp"
#include "numeric/number/estimate.hpp"

namespace steadyslide::library {

template <numeric::Real R>
std::string format_number(const R& value, int digits);

/// Shows only digits that the error supports: the last digit is worth at least the error. A value larger than its error
/// keeps at least one digit. A value that does not exceed its error has no digit of its own: the text is "80 +/- 120",
/// rounded at the last digit of the error; a 0 alone is exact. An infinite error means that the value is not known: the
/// text is empty, unless the value is infinite itself.
template <numeric::Real R>
std::string format_number(const numeric::Estimate<R>& estimate, int digits);

/// Returns the whole number, for files: `digits` significant digits. For 16 digits, it is the shortest decimal that a
/// reader of doubles turns into the double nearest to the value.
template <numeric::Real R>
std::string full_number(const R& value, int digits);
std::string full_number(const Rational& value, int digits);

/// Returns the absolute error of the text of a finite estimate: the error of the estimate plus the rounding of the text.
template <numeric::Real R>
R error_of_text(const std::string& text, const numeric::Estimate<R>& estimate);

/// An estimate as texts, for a person and for a file. The texts are empty if the value is not known.
struct NumberText {
  std::string shown;    ///< the digits that the error supports
  std::string value;    ///< all digits
  std::string error;    ///< absolute error of `value`, two digits, rounded up; 0 for an infinite limit
  bool proved = false;  ///< true: the error is a bound; false: an estimate
};

/// A proved number. Every number in the ball, rounded to as many digits as the text has, is that text. If there is no
/// such digit, the text is "value +/- error". The error bounds the distance of the value's text from every number in
/// the ball.
NumberText number_text(const enclosure::Ball& ball, int digits);
/// An upper bound: no number in the ball exceeds it.
std::string upper_text(const enclosure::Ball& ball, int digits = 2);
/// A lower bound: no number in the ball is below it.
std::string lower_text(const enclosure::Ball& ball, int digits = 2);

template <numeric::Real R>
NumberText number_text(const numeric::Estimate<R>& estimate, int digits);

/// A text for sizes of which only the order matters: errors, residuals.
template <numeric::Real R>
std::string size_text(const R& value, int digits);

/// Returns the value rounded to `digits`.
std::string format_number(const Rational& value, int digits);

/// Returns exactly the value, in a form that parse_rational reads: "-0.25", "1/3", "1e-400".
std::string exact_text(const Rational& value);

/// An exponent as texts.
struct ExponentText {
  std::string value;     ///< all `digits` correct: evaluated with guard digits
  std::string symbolic;  ///< exact, "-1/2 - arctan(3/35)/pi"
  std::string latex;     ///< exact, for math mode
};

/// An absent exponent means a logarithm.
ExponentText exponent_text(const std::optional<Exponent>& exponent, int digits);

/// "F/L^(3/2 - arctan(3/35)/pi)": the unit of a stress times a length to minus the exponent; F force, L length.
std::string stress_intensity_unit(const Exponent& exponent);

/// Returns only the value.
std::string format_exponent(const Exponent& exponent, int digits);
/// The enclosed exponent; "log" if it is absent.
NumberText proved_exponent(const std::optional<Exponent>& exponent, int digits);

}  // namespace steadyslide::library
