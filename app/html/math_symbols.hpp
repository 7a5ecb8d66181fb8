#pragma once
// The words of a formula in ASCII, and what its names and signs look like (docs/theory.md, "Formulas in text").

#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

struct MathToken {
  enum class Kind { name, number, sign, end };

  Kind kind = Kind::end;
  std::string text;
  bool space_before = false;

  bool is(std::string_view sign) const { return kind == Kind::sign && text == sign; }
};

/// The last token is an end. Nothing for a formula with a character that the notation does not have.
std::optional<std::vector<MathToken>> math_tokens(std::string_view formula);

}  // namespace steadyslide::app
