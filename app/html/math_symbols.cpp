#include "app/html/math_symbols.hpp"

#include <algorithm>
#include <map>
#include <regex>

namespace steadyslide::app {
namespace {

using Symbols = std::map<std::string_view, MathSymbol>;

/// Removes the first word from words that are separated by spaces, and returns it.
std::string_view next_word(std::string_view& words) {
  const std::string_view word = words.substr(0, words.find(' '));
  words.remove_prefix(std::min(word.size() + 1, words.size()));
  return word;
}

/// Adds names, each followed by its glyph: "alpha α beta β".
void add(Symbols& symbols, MathRole role, std::string_view names_and_glyphs, bool upright = false) {
  while (!names_and_glyphs.empty()) {
    const std::string_view name = next_word(names_and_glyphs);
    symbols[name] = {next_word(names_and_glyphs), role, upright};
  }
}

/// Adds names that are set as they are written.
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

/// Matches blanks, then a number (12, 0.5, 1.9490..., 3e-52), a name, a sign or the end of the text. If two signs have
/// the same beginning, the longer one comes first. << and >> are duality brackets.
const std::regex& token() {
  static const std::regex all(
      R"(([ \n\t]*)(?:(\d+(?:\.\d+)?(?:e[-+]?\d+(?![A-Za-z\d]))?)|([A-Za-z]+)|)"
      R"((<=>|<->|\.\.\.|<=|>=|!=|->|=>|:=|\+-|-\+|<<|>>|\|->|==|~=|<-|[-+*/=<>~()[\]{}|,;:!_^'])|$))");
  return all;
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
  using enum MathToken::Kind;
  std::vector<MathToken> tokens;
  auto at = formula.begin();
  std::match_results<std::string_view::iterator> found;
  while (std::regex_search(at, formula.end(), found, token(), std::regex_constants::match_continuous)) {
    const auto kind = found[2].matched ? number : found[3].matched ? name : found[4].matched ? sign : end;
    const bool in_script = !tokens.empty() && (tokens.back().is("_") || tokens.back().is("^"));
    std::string text(found[1].second, found[0].second);
    if (in_script && text == "->") text = "-";  // <<1, t_->>
    at = found[1].second + static_cast<std::ptrdiff_t>(text.size());
    // punch-any-jumps is one name, not a difference.
    const auto is_word = [](const MathToken& t) { return t.kind == name && t.text.size() > 2 && !math_name(t.text); };
    const std::size_t n = tokens.size();
    const MathToken read{kind, std::move(text), found.length(1) > 0};
    if (is_word(read) && n > 1 && tokens[n - 1].is("-") && !read.space_before && !tokens[n - 1].space_before &&
        is_word(tokens[n - 2])) {
      tokens.pop_back();
      tokens.back().text += "-" + read.text;
    } else {
      tokens.push_back(read);
    }
    if (kind == end) return tokens;
  }
  return std::nullopt;
}

}  // namespace steadyslide::app
