// Formulas in lines of plain HTML.

#include <fmt/format.h>

#include <algorithm>

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

constexpr std::string_view slant = "<i>", upright = "</i>";

bool is_slanted(std::string_view html) {
  return html.starts_with(slant) && html.ends_with(upright) && html.find(slant, 1) == std::string_view::npos;
}

/// Returns the slanted text without its marks.
std::string_view inside(std::string_view html) {
  return html.substr(slant.size(), html.size() - slant.size() - upright.size());
}

/// Appends HTML. Slanted letters side by side have one element.
void append(std::string& html, bool spaced, std::string_view more) {
  if (is_slanted(more) && html.ends_with(upright)) {
    html.resize(html.size() - upright.size());
    html += (spaced ? " " : "") + std::string(inside(more)) + std::string(upright);
  } else {
    html += (spaced && !html.empty() ? " " : "") + std::string(more);
  }
}

/// Writes the tokens of a formula, which parse_math() has accepted, in one line.
class Line {
 public:
  explicit Line(const std::vector<MathToken>& tokens) : tokens_(tokens) {}

  /// Returns the tokens up to `close`, or up to the end.
  std::string row(std::string_view close = "") {
    std::string html;
    for (; token().kind != MathToken::Kind::end && !(token().is(close) && !close.empty());) {
      if (token().is("_") || token().is("^")) {
        add_script(html);
      } else {
        const bool spaced = token().space_before;
        append(html, spaced, leaf(html.empty() || spaced));
      }
    }
    return html;
  }

 private:
  const MathToken& token(std::size_t ahead = 0) const { return tokens_[std::min(at_ + ahead, tokens_.size() - 1)]; }

  /// Returns the next token; `first`: no other token is close before it. Round brackets stay with their contents.
  std::string leaf(bool first) {
    const MathToken t = token();
    ++at_;
    if (t.kind == MathToken::Kind::number) {
      const bool index = !first && at_ > 1 && tokens_[at_ - 2].kind == MathToken::Kind::name;
      return index ? "<sub>" + t.text + "</sub>" : number_text(t.text);
    }
    if (t.kind == MathToken::Kind::name) return t.text == "sqrt" ? root() : name(t.text);
    if (t.is("(")) {
      std::string group = "(" + row(")");
      if (!token().is(")")) return group;  // (0, 1]
      ++at_;
      return group + ")";
    }
    const auto symbol = math_sign(t.text);
    return symbol                   ? std::string(symbol->glyph)
           : t.is("'")              ? "′"
           : t.is("<<")             ? "⟨"
           : t.is(">>")             ? "⟩"
           : t.is("{") || t.is("}") ? ""
                                    : t.text;
  }

  static std::string name(const std::string& text) {
    const auto symbol = math_name(text);
    const std::string glyph(symbol ? symbol->glyph : std::string_view(text));
    const bool is_upright =
        symbol ? symbol->upright || symbol->role != MathRole::operand : glyph.size() > 2 || glyph == "PV";
    return is_upright ? glyph : std::string(slant) + glyph + std::string(upright);
  }

  /// Returns the operand of a root with its scripts, below a line.
  std::string root() {
    std::string under = leaf(true);
    const bool power = token().is("_") || token().is("^");
    if (!power && under.starts_with("(") && under.ends_with(")")) under = under.substr(1, under.size() - 2);
    while (token().is("_") || token().is("^")) add_script(under);
    return "√" + span("root", under);
  }

  /// Reads "_" or "^" and the script behind it.
  void add_script(std::string& html) {
    const std::string_view tag = token().is("_") ? "sub" : "sup";
    ++at_;
    if (const auto accent = tag == "sub" ? combining(token().text) : std::nullopt; accent && html.ends_with(upright)) {
      ++at_;
      html.insert(html.size() - upright.size(), *accent);
      return;
    }
    const std::string script = read_script();
    if (html.ends_with(upright) && is_slanted(script)) {
      html.resize(html.size() - upright.size());
      html += element(tag, inside(script)) + std::string(upright);
    } else {
      html += element(tag, script);
    }
  }

  std::string read_script() {
    if (token().is("{")) {
      ++at_;
      std::string html = row("}");
      ++at_;
      return html;
    }
    std::string html = leaf(true);
    const bool sign = tokens_[at_ - 1].kind == MathToken::Kind::sign && !tokens_[at_ - 1].is(")");
    const bool operand = token().kind == MathToken::Kind::number || token().kind == MathToken::Kind::name;
    if (sign && operand && !token().space_before) append(html, false, leaf(true));
    return html;
  }

  static std::optional<std::string_view> combining(std::string_view accent) {
    if (!math_accent(accent)) return std::nullopt;
    return accent == "bar" ? "\u0304" : accent == "tilde" ? "\u0303" : "\u0302";
  }

  const std::vector<MathToken>& tokens_;
  std::size_t at_ = 0;
};

/// Returns a formula in one line of HTML with slanted letters. Returns nothing if the text is no formula.
std::optional<std::string> in_line(std::string_view formula) {
  const auto tokens = math_tokens(formula);
  if (!tokens || !parse_math(formula)) return std::nullopt;
  return Line(*tokens).row();
}

}  // namespace

std::string lined(std::string_view text) {
  std::string result;
  while (true) {
    const std::size_t begin = text.find('`');
    const std::size_t end = begin == std::string_view::npos ? begin : text.find('`', begin + 1);
    if (end == std::string_view::npos) return result + escaped(text);
    const std::string_view formula = text.substr(begin + 1, end - begin - 1);
    result += escaped(text.substr(0, begin)) + in_line(formula).value_or(code(formula));
    text.remove_prefix(end + 1);
  }
}

}  // namespace steadyslide::app
