#pragma once
// The words of a formula in ASCII: names, numbers, signs.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steadyslide::app {

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
