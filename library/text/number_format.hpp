#pragma once
// Numbers as text: N significant digits rounded to nearest, zeros at the end dropped; plain where the decimal exponent
// lies in [-5, N[, else like 1.5e-30; zero as 0, infinities as inf and -inf, and no text for what is no number.

#include <optional>
#include <string>

#include "enclosure/number/ball.hpp"
#include "model/exponent.hpp"
#include "numeric/number/estimate.hpp"

namespace steadyslide::library {

template <numeric::Real R>
std::string format_number(const R& value, int digits);

/// Only digits that the error supports: the last one printed is worth at least the error. One digit is left to a value
/// larger than its error. A value that does not exceed its error has no digit of its own: "80 +/- 120", rounded where its
/// error is; a 0 alone is exact. An infinite error says that the value is not known: no text, unless the value is infinite
/// itself.
template <numeric::Real R>
std::string format_number(const numeric::Estimate<R>& estimate, int digits);

/// All of a number, for files: `digits` significant digits; where 16 are asked for, the shortest decimal that a reader
/// of doubles turns into the double nearest to the value.
template <numeric::Real R>
std::string full_number(const R& value, int digits);
std::string full_number(const Rational& value, int digits);

/// An estimate as results tell it, to a person and to a file. Empty texts: not known.
struct NumberText {
  std::string shown;    ///< the digits that the error supports
  std::string value;    ///< all digits
  std::string error;    ///< absolute, two digits, rounded up, of what `value` says; 0 for an infinite limit
  bool proved = false;  ///< the error is a bound, else an estimate
};

/// A proved number: every number in the ball, rounded to as many digits, is the text shown; where there is no such digit
/// "value +/- error". The error is a bound on the distance of the value's text from every number in the ball.
NumberText number_text(const enclosure::Ball& ball, int digits);
/// A bound: no number in the ball exceeds it.
std::string upper_text(const enclosure::Ball& ball, int digits = 2);

template <numeric::Real R>
NumberText number_text(const numeric::Estimate<R>& estimate, int digits);

/// Of sizes that matter by their order only: errors, residuals.
template <numeric::Real R>
std::string size_text(const R& value, int digits);

/// The exact value rounded to `digits`.
std::string format_number(const Rational& value, int digits);

/// Exactly the value, in a form that parse_rational reads back: "-0.25", "1/3", "1e-400".
std::string exact_text(const Rational& value);

/// An exponent as results show it.
struct ExponentText {
  std::string value;     ///< all `digits` right: evaluated with guard digits
  std::string symbolic;  ///< exact, "-1/2 - arctan(3/35)/pi"
  std::string latex;     ///< exact, for math mode
};

/// Absent: a logarithm.
ExponentText exponent_text(const std::optional<Exponent>& exponent, int digits);

/// "F/L^(3/2 - arctan(3/35)/pi)": a stress times a length to minus the exponent; F force, L length.
std::string stress_intensity_unit(const Exponent& exponent);

/// The value alone.
std::string format_exponent(const Exponent& exponent, int digits);
/// Enclosed; "log" where there is none.
NumberText proved_exponent(const std::optional<Exponent>& exponent, int digits);

}  // namespace steadyslide::library
