#pragma once
// The tokens of a formula in ASCII, and the glyphs of its names and signs (docs/theory.md, "Formulas in text").

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

/// Returns the symbol of a name that is more than its letters: alpha, sin, int, in, oo. Returns nothing for other
/// names.
std::optional<MathSymbol> math_name(std::string_view name);
/// Returns the symbol of a sign that stands between or before operands. Returns nothing for brackets, scripts and the
/// solidus.
std::optional<MathSymbol> math_sign(std::string_view sign);
/// Returns the accent of `bar`, `tilde` or `hat`. They follow a name with an underscore, and their accent is set above
/// it: x_bar. Returns nothing for other names.
std::optional<std::string_view> math_accent(std::string_view name);

struct MathToken {
  enum class Kind { name, number, sign, end };

  Kind kind = Kind::end;
  std::string text;
  bool space_before = false;

  bool is(std::string_view sign) const { return kind == Kind::sign && text == sign; }
};

/// Splits a formula into tokens; the last one is of the kind `end`. Returns nothing if a character is not in the
/// notation.
std::optional<std::vector<MathToken>> math_tokens(std::string_view formula);

}  // namespace steadyslide::app
