#pragma once
// A number rounded to N significant decimal digits: the text, and the exact value of this text.

#include <string>

#include "model/rational.hpp"

namespace steadyslide::symbolic {

struct Decimal {
  Rational value;
  std::string text;  ///< "-0.01230", "1.50e-30", "0": all N digits, with an exponent below 1e-5 and from 1eN
};

/// Rounds to nearest, halves away from zero. Throws std::domain_error unless digits >= 1.
Decimal rounded(const Rational& value, int digits);

}  // namespace steadyslide::symbolic
