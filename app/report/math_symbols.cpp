#include "app/report/math_symbols.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace steadyslide::app {
namespace {

using Symbols = std::map<std::string_view, MathSymbol>;

/// Takes a word off the front of words that are separated by spaces.
std::string_view next_word(std::string_view& words) {
  const std::string_view word = words.substr(0, words.find(' '));
  words.remove_prefix(std::min(word.size() + 1, words.size()));
  return word;
}

/// "alpha α beta β": each name is followed by its glyph.
void add(Symbols& symbols, MathRole role, std::string_view names_and_glyphs, bool upright = false) {
  while (!names_and_glyphs.empty()) {
    const std::string_view name = next_word(names_and_glyphs);
    symbols[name] = {next_word(names_and_glyphs), role, upright};
  }
}

/// Names that are set as they are written.
void add_words(Symbols& symbols, MathRole role, std::string_view words) {
  while (!words.empty()) {
    const std::string_view word = next_word(words);
    symbols[word] = {word, role, true};
  }
}

Symbols all_names() {
  Symbols names;
  add(names, MathRole::operand,
      "alpha α beta β gamma γ delta δ epsilon ε eps ε zeta ζ eta η theta θ iota ι kappa κ lambda λ mu μ nu ν xi ξ pi π "
      "rho ρ sigma σ tau τ upsilon υ phi φ chi χ psi ψ omega ω ell ℓ Gamma Γ Delta Δ Theta Θ Lambda Λ Xi Ξ Pi Π "
      "Sigma Σ Upsilon Υ Phi Φ Psi Ψ Omega Ω");
  add(names, MathRole::operand, "oo ∞ partial ∂ nabla ∇ emptyset ∅", true);
  add(names, MathRole::big, "int ∫ sum ∑ prod ∏ oint ∮");
  add(names, MathRole::relation, "in ∈ notin ∉ subset ⊂ approx ≈ propto ∝ equiv ≡");
  add(names, MathRole::binary, "cup ∪ cap ∩ times × cdot ⋅ setminus ∖");
  add_words(names, MathRole::function,
            "sin cos tan cot sec csc arcsin arccos arctan arccot sinh cosh tanh log ln exp max min sup inf lim arg det "
            "dim deg Re Im sinc sign sgn supp limsup");
  add_words(names, MathRole::word, "for and or if on where with of as while at to not");
  return names;
}

Symbols all_signs() {
  Symbols signs;
  add(signs, MathRole::relation, "= = < &lt; > &gt; <= ≤ >= ≥ != ≠ ~ ∼ ~= ≈ -> → <- ← => ⇒ <=> ⇔ <-> ↔ := ≔ |-> ↦");
  add(signs, MathRole::binary, "+ + - − +- ± -+ ∓ * ∗");
  add(signs, MathRole::punctuation, ", , ; ; : :");
  return signs;
}

std::optional<MathSymbol> found(const Symbols& symbols, std::string_view name) {
  const auto symbol = symbols.find(name);
  return symbol == symbols.end() ? std::nullopt : std::optional(symbol->second);
}

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

std::optional<MathSymbol> math_name(std::string_view name) {
  static const Symbols names = all_names();
  return found(names, name);
}

std::optional<MathSymbol> math_sign(std::string_view sign) {
  static const Symbols signs = all_signs();
  return found(signs, sign);
}

std::optional<std::string_view> math_accent(std::string_view name) {
  if (name == "bar") return "‾";
  if (name == "tilde") return "˜";
  if (name == "hat") return "^";
  return std::nullopt;
}

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
