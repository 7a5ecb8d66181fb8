#include "app/report/math_tokens.hpp"

#include <algorithm>
#include <array>

namespace steadyslide::app {
namespace {

// Longer ones first. `<<` and `>>` are duality brackets.
constexpr std::array<std::string_view, 17> long_signs{
    "<=>", "<->", "...", "<=", ">=", "!=", "->", "=>", ":=", "+-", "-+", "<<", ">>", "|->", "==", "~=", "<-"};
constexpr std::string_view short_signs = "+-*/=<>~()[]{}|,;:!_^'";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The length of the number at the beginning: 12, 0.5, 1.9490..., 3e-52.
std::size_t number_length(std::string_view text) {
  const auto digits = [&](std::size_t from) {
    std::size_t end = from;
    while (end < text.size() && is_digit(text[end])) ++end;
    return end - from;
  };
  std::size_t length = digits(0);
  if (length == 0) return 0;
  if (length + 1 < text.size() && text[length] == '.' && is_digit(text[length + 1])) length += 1 + digits(length + 1);
  if (length >= text.size() || text[length] != 'e') return length;
  std::size_t exponent = length + 1;
  if (exponent < text.size() && (text[exponent] == '-' || text[exponent] == '+')) ++exponent;
  const std::size_t more = digits(exponent);
  const bool ends = exponent + more >= text.size() || !is_letter(text[exponent + more]);
  return more > 0 && ends ? exponent + more : length;
}

std::size_t name_length(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::find_if_not(text, is_letter) - text.begin());
}

std::size_t sign_length(std::string_view text, bool script) {
  if (script && text.starts_with("->")) return 1;  // <<1, t_->>
  for (const std::string_view sign : long_signs) {
    if (text.starts_with(sign)) return sign.size();
  }
  return short_signs.find(text.front()) == std::string_view::npos ? 0 : 1;
}

}  // namespace

std::optional<std::vector<MathToken>> math_tokens(std::string_view formula) {
  using Kind = MathToken::Kind;
  std::vector<MathToken> tokens;
  bool space = false;
  const auto in_script = [&] { return !tokens.empty() && (tokens.back().is("_") || tokens.back().is("^")); };
  while (!formula.empty()) {
    if (formula.front() == ' ' || formula.front() == '\n' || formula.front() == '\t') {
      space = true;
      formula.remove_prefix(1);
      continue;
    }
    const auto [kind, length] = is_digit(formula.front())    ? std::pair(Kind::number, number_length(formula))
                                : is_letter(formula.front()) ? std::pair(Kind::name, name_length(formula))
                                                             : std::pair(Kind::sign, sign_length(formula, in_script()));
    if (length == 0) return std::nullopt;
    tokens.push_back({kind, std::string(formula.substr(0, length)), space});
    space = false;
    formula.remove_prefix(length);
  }
  tokens.push_back({Kind::end, "", space});
  return tokens;
}

}  // namespace steadyslide::app
