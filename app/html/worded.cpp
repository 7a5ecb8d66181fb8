// Formulas in words that do not mark them, found token by token.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "app/html/html.hpp"
#include "app/html/math_row.hpp"
#include "app/html/mathml.hpp"

namespace steadyslide::app {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_decimal_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// A name of the notation that stands for something: x, alpha, sqrt, dx.
bool is_known(std::string_view name) {
  if (const auto symbol = math_name(name)) return symbol->role != MathRole::word && symbol->role != MathRole::relation;
  const bool differential = name.front() == 'd' && (name.size() == 2 || math_name(name.substr(1)));
  return name.size() == 1 || name == "sqrt" || name == "PV" || math_accent(name) || differential;
}

enum class Kind { word, number, name, formula, sign };

/// Of a text between blanks, without the punctuation behind it.
Kind kind_of(std::string_view token) {
  if (token.empty()) return Kind::word;
  bool letters = false;
  for (std::size_t at = 0; at < token.size();) {
    if (static_cast<unsigned char>(token[at]) >= 0x80 || token[at] == '"' || token[at] == '`') return Kind::word;
    std::size_t end = at;
    while (end < token.size() && is_letter(token[end])) ++end;
    if (end > at) {
      const std::string_view name = token.substr(at, end - at);
      const bool power_of_ten = name == "e" && at > 0 && is_decimal_digit(token[at - 1]);
      if (!power_of_ten && !is_known(name)) return Kind::word;
      letters = letters || !power_of_ten;
    }
    at = std::max(end, at + 1);
  }
  const bool digits = std::ranges::any_of(token, is_decimal_digit);
  if (!letters) return digits ? Kind::number : math_sign(token) || token == "/" ? Kind::sign : Kind::word;
  const bool plain = std::ranges::all_of(token, is_letter);
  if (!plain)
    return token.find_first_of("^_=<>+*/()|'-[]") == std::string_view::npos && !digits ? Kind::word : Kind::formula;
  const auto symbol = math_name(token);
  if (token == "int") return Kind::name;
  if (symbol && symbol->role != MathRole::operand) return Kind::word;
  return token.size() == 1 || symbol ? Kind::name : Kind::word;
}

/// As number_item() has it.
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

/// A formula in one line of HTML, letters slanted, a tenth of its MathML: for words of which there are thousands. Nothing
/// where it takes more than scripts.
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
      if (token.text == "sqrt" || (symbol && symbol->role == MathRole::big)) return std::nullopt;
      const std::string glyph(symbol ? symbol->glyph : std::string_view(token.text));
      const bool upright = symbol ? symbol->upright || symbol->role != MathRole::operand : glyph.size() > 2;
      html += (spaced ? " " : "") + (upright ? glyph : "<i>" + glyph + "</i>");
    } else {
      if (token.is("{") || token.is("<<") || token.is(">>")) return std::nullopt;
      html += (spaced ? " " : "") + (symbol ? std::string(symbol->glyph) : token.is("'") ? "′" : token.text);
    }
    const bool sign_of_script =
        token.kind == MathToken::Kind::sign && (*tokens)[at + 1].kind == MathToken::Kind::number;
    if (!closing.empty() && !in_braces && !sign_of_script) html += std::exchange(closing, "");
  }
  return html + closing;
}

/// -1 with a minus sign, where the hyphen joins no words.
std::string real_minus(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool number = text[at] == '-' && at + 1 < text.size() && is_decimal_digit(text[at + 1]);
    const bool begins = at == 0 || std::string_view(" ([],").find(text[at - 1]) != std::string_view::npos;
    if (number && begins) {
      result += "−";
    } else {
      result += text[at];
    }
  }
  return result;
}

struct Token {
  std::string_view text;
  std::string_view behind;  ///< punctuation
  Kind kind;
};

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  while (true) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view whole = text.substr(0, end);
    const std::size_t last = whole.ends_with("...") ? std::string_view::npos : whole.find_last_not_of(",;:.");
    const std::size_t length = last == std::string_view::npos ? whole.size() : last + 1;
    tokens.push_back({whole.substr(0, length), whole.substr(length), kind_of(whole.substr(0, length))});
    if (end == text.size()) return tokens;
    text.remove_prefix(end + 1);
  }
}

/// How many tokens from the first one on are one formula; 0 if it begins none.
std::size_t formula_length(const std::vector<Token>& tokens, std::size_t first) {
  std::size_t length = 0;
  bool operand = false;
  for (std::size_t at = first; at < tokens.size(); ++at) {
    const Kind kind = tokens[at].kind;
    if (kind == Kind::word) break;
    if (kind == Kind::number && operand && tokens[at - 1].kind != Kind::sign) break;
    operand = kind != Kind::sign;
    if (operand) length = at + 1 - first;
    if (!tokens[at].behind.empty()) break;
  }
  if (length == 1) {
    const auto& [text, behind, kind] = tokens[first];
    const bool power = kind == Kind::number && text.find('e') != std::string_view::npos;
    const bool article = text == "a" || text == "A" || text == "I";
    if (!power && (kind == Kind::number || kind == Kind::sign || article)) return 0;
  }
  return length;
}

/// The text without backticks, as HTML.
std::string typeset(std::string_view text) {
  const std::vector<Token> tokens = tokens_of(text);
  std::string result;
  for (std::size_t at = 0; at < tokens.size();) {
    if (at > 0) result += ' ';
    std::size_t length = formula_length(tokens, at);
    // The longest beginning that can be read as a formula.
    for (; length > 0; --length) {
      const char* begin = tokens[at].text.data();
      const std::string_view last = tokens[at + length - 1].text;
      std::string formula(begin, static_cast<std::size_t>(last.data() + last.size() - begin));
      // 4*nu in the words of a computer algebra system is a product, t * log a convolution.
      for (std::size_t star = 1; star + 1 < formula.size(); ++star) {
        if (formula[star] == '*' && formula[star - 1] != ' ' && formula[star + 1] != ' ') formula[star] = ' ';
      }
      const auto line = in_line(formula);
      const auto html = line ? line : mathml(formula);
      if (!html) continue;
      result += *html + escaped(tokens[at + length - 1].behind);
      break;
    }
    if (length == 0) result += escaped(real_minus(tokens[at].text) + std::string(tokens[at].behind));
    at += std::max<std::size_t>(length, 1);
  }
  return result;
}

/// The formulas between backticks in a line of HTML where that does, else as MathML; the words between them as `words` has them.
template <class Words>
std::string with_formulas(std::string_view text, Words words) {
  std::string result;
  while (true) {
    const std::size_t begin = text.find('`');
    if (begin == std::string_view::npos) return result + words(text);
    const std::size_t end = text.find('`', begin + 1);
    if (end == std::string_view::npos) return result + escaped(text);
    const auto line = in_line(text.substr(begin + 1, end - begin - 1));
    result += words(text.substr(0, begin)) + (line ? *line : prose(text.substr(begin, end + 1 - begin)));
    text.remove_prefix(end + 1);
  }
}

}  // namespace

std::string worded(std::string_view text) { return with_formulas(text, typeset); }
std::string lined(std::string_view text) { return with_formulas(text, escaped); }

}  // namespace steadyslide::app
