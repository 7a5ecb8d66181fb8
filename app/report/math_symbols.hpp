#pragma once
// What the names and signs of the notation look like (docs/notation.md, "Formulas in text").

#include <optional>
#include <string_view>

namespace steadyslide::app {

enum class MathRole { operand, function, big, binary, relation, punctuation, word };

struct MathSymbol {
  std::string_view glyph;  ///< UTF-8
  MathRole role;
  bool upright = false;
};

/// Names that are more than their letters: alpha, sin, int, in, oo.
std::optional<MathSymbol> math_name(std::string_view name);
/// Signs that stand between or before operands; none for brackets, scripts and the solidus.
std::optional<MathSymbol> math_sign(std::string_view sign);
/// `bar`, `tilde`, `hat`: what is set above a name that they follow with an underscore.
std::optional<std::string_view> math_accent(std::string_view name);

}  // namespace steadyslide::app
