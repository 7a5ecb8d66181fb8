// Formulas in words that do not mark them, found token by token.

#include <algorithm>
#include <cctype>
#include <vector>

#include "app/html/html.hpp"
#include "app/html/math_symbols.hpp"
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
      const auto html = mathml(formula);
      if (!html) continue;
      result += *html + escaped(tokens[at + length - 1].behind);
      break;
    }
    if (length == 0) result += escaped(real_minus(tokens[at].text) + std::string(tokens[at].behind));
    at += std::max<std::size_t>(length, 1);
  }
  return result;
}

}  // namespace

std::string worded(std::string_view text) {
  std::string result;
  while (true) {
    const std::size_t begin = text.find('`');
    if (begin == std::string_view::npos) return result + typeset(text);
    const std::size_t end = text.find('`', begin + 1);
    if (end == std::string_view::npos) return result + escaped(text);
    result += typeset(text.substr(0, begin)) + prose(text.substr(begin, end + 1 - begin));
    text.remove_prefix(end + 1);
  }
}

}  // namespace steadyslide::app
