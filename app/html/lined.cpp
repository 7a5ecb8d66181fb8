#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/html/html.hpp"
#include "app/html/math_row.hpp"
#include "app/html/mathml.hpp"

namespace steadyslide::app {
namespace {

/// Returns a number as HTML, with the same shortening and the same power of ten as number_item().
std::string number_text(std::string_view digits) {
  const std::size_t e = digits.find('e');
  if (e == std::string_view::npos) {
    constexpr std::size_t longest = 14, kept = 9;
    if (digits.size() <= longest) return std::string(digits);
    return fmt::format(R"(<span title="{}">{}…</span>)", digits, digits.substr(0, kept));
  }
  const std::size_t first = std::min(digits.find_first_not_of("+-0", e + 1), digits.size());
  const std::string power = fmt::format("10<sup>{}{}</sup>", digits[e + 1] == '-' ? "−" : "", digits.substr(first));
  const std::string_view mantissa = digits.substr(0, e);
  return first == digits.size()                 ? std::string(mantissa)
         : mantissa == "1" || mantissa == "1.0" ? power
                                                : fmt::format("{}×{}", mantissa, power);
}

/// Returns a formula in one line of HTML with slanted letters. This has a tenth of the size of its MathML, for a page
/// with thousands of formulas. Returns nothing if the text is no formula, or needs more than subscripts and
/// superscripts.
std::optional<std::string> in_line(std::string_view formula) {
  const auto tokens = math_tokens(formula);
  if (!tokens || !parse_math(formula)) return std::nullopt;
  std::string html, closing;
  bool in_braces = false;
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    const MathToken& token = (*tokens)[at];
    const auto symbol = token.kind == MathToken::Kind::name ? math_name(token.text) : math_sign(token.text);
    if (token.is("_") || token.is("^")) {
      const MathToken& next = (*tokens)[at + 1];
      if (!closing.empty() || next.is("(") || math_accent(next.text)) return std::nullopt;
      html += token.is("_") ? "<sub>" : "<sup>";
      closing = token.is("_") ? "</sub>" : "</sup>";
      in_braces = next.is("{");
      if (in_braces) ++at;
      continue;
    }
    if (token.is("}")) {
      html += std::exchange(closing, "");
      in_braces = false;
      continue;
    }
    const bool spaced = token.space_before && !html.empty();
    if (token.kind == MathToken::Kind::number) {
      const bool index =
          at > 0 && closing.empty() && !token.space_before && (*tokens)[at - 1].kind == MathToken::Kind::name;
      html += (spaced ? " " : "") + (index ? "<sub>" + token.text + "</sub>" : number_text(token.text));
    } else if (token.kind == MathToken::Kind::name) {
      if (token.text == "sqrt") return std::nullopt;
      const std::string glyph(symbol ? symbol->glyph : std::string_view(token.text));
      const bool upright =
          symbol ? symbol->upright || symbol->role != MathRole::operand : glyph.size() > 2 || glyph == "PV";
      html += (spaced ? " " : "") + (upright ? glyph : "<i>" + glyph + "</i>");
    } else {
      if (token.is("{")) return std::nullopt;
      const std::string sign = token.is("'") ? "′" : token.is("<<") ? "⟨" : token.is(">>") ? "⟩" : token.text;
      html += (spaced ? " " : "") + (symbol ? std::string(symbol->glyph) : sign);
    }
    const MathToken& behind = (*tokens)[at + 1];
    const bool sign_of_script = token.kind == MathToken::Kind::sign && !behind.space_before &&
                                (behind.kind == MathToken::Kind::number || behind.kind == MathToken::Kind::name);
    if (!closing.empty() && !in_braces && !sign_of_script) html += std::exchange(closing, "");
  }
  return html + closing;
}

}  // namespace

std::string lined(std::string_view text) {
  std::string result;
  while (true) {
    const std::size_t begin = text.find('`');
    const std::size_t end = begin == std::string_view::npos ? begin : text.find('`', begin + 1);
    if (end == std::string_view::npos) return result + escaped(text);
    const auto line = in_line(text.substr(begin + 1, end - begin - 1));
    result += escaped(text.substr(0, begin)) + (line ? *line : prose(text.substr(begin, end + 1 - begin)));
    text.remove_prefix(end + 1);
  }
}

}  // namespace steadyslide::app
