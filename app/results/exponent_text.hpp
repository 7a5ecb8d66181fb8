#pragma once
// An exponent as results show it.

#include <optional>
#include <string>

#include "model/exponent.hpp"

namespace steadyslide::app {

struct ExponentText {
  std::string value;     ///< all `digits` right: evaluated with guard digits
  std::string symbolic;  ///< exact, "-1/2 - arctan(3/35)/pi"
  std::string latex;     ///< exact, for math mode
};

/// Absent: a logarithm.
ExponentText exponent_text(const std::optional<Exponent>& exponent, int digits);

/// The value alone.
std::string format_exponent(const Exponent& exponent, int digits);

}  // namespace steadyslide::app
