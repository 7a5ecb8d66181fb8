#include <cctype>
#include <regex>

#include "app/report/math_symbols.hpp"
#include "app/report/math_tokens.hpp"
#include "app/report/mathml.hpp"
#include "app/terminal/utf8.hpp"
#include "support/test.hpp"

using namespace steadyslide::app;

namespace {

/// Without what is said of spaces and forms, and without rows: what a reader of a table of cases can take in.
std::string bare(std::string_view formula) {
  const auto typeset = mathml(formula);
  if (!typeset) return "none";
  std::string xml = std::regex_replace(*typeset, std::regex("</?mrow>|<mspace[^>]*/>"), "");
  return std::regex_replace(xml, std::regex("<(\\w+) [^>]*>"), "<$1>");
}

/// Elements closed in order, entities and attributes whole.
bool is_well_formed(const std::string& xml) {
  static const std::regex piece(
      "<(/?)([A-Za-z][A-Za-z0-9]*)((?: [a-z-]+=\"[^\"<&]*\")*)(/?)>|&(?:lt|gt|amp|quot);|[^<>&]");
  std::vector<std::string> open;
  auto at = xml.cbegin();
  for (std::smatch match; at != xml.cend(); at = match[0].second) {
    if (!std::regex_search(at, xml.cend(), match, piece, std::regex_constants::match_continuous)) return false;
    if (!match[2].matched || match[4].length() > 0) continue;
    if (match[1].length() == 0) {
      open.push_back(match[2]);
    } else if (open.empty() || open.back() != match[2]) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return open.empty();
}

/// What is seen of it.
std::string text_of(const std::string& xml) { return std::regex_replace(xml, std::regex("<[^>]*>"), ""); }

/// The letters and digits of a text, Latin and Greek, sorted: scripts may change places.
std::string letters_of(std::string_view text) {
  std::vector<std::string> letters;
  for (; !text.empty();) {
    const Utf8Character c = first_character(text);
    const bool latin = c.code < 0x80 && std::isalnum(static_cast<unsigned char>(text.front())) != 0;
    const bool greek = c.code >= 0x370 && c.code < 0x400;
    if (latin || greek) letters.emplace_back(text.substr(0, c.length));
    text.remove_prefix(std::max<std::size_t>(c.length, 1));
  }
  std::ranges::sort(letters);
  std::string joined;
  for (const std::string& letter : letters) joined += letter;
  return joined;
}

std::string glyph_of(const std::string& name) {
  const auto symbol = math_name(name);
  return symbol ? std::string(symbol->glyph) : name;
}

/// What of a formula has to be seen on the page: its names by their glyphs, and its numbers.
std::string expected_letters(std::string_view formula) {
  std::string text;
  const std::vector<MathToken> tokens = math_tokens(formula).value();
  for (const MathToken& token : tokens) {
    const bool accent = math_accent(token.text).has_value();
    const bool drawn = token.text == "sqrt";
    if (token.kind == MathToken::Kind::number) text += token.text;
    if (token.kind != MathToken::Kind::name || accent || drawn) continue;
    const bool differential = token.text.size() > 1 && token.text.front() == 'd' && !math_name(token.text);
    text += differential ? "d" + glyph_of(token.text.substr(1)) : glyph_of(token.text);
  }
  return letters_of(text);
}

/// A formula by the rules of the notation. Nothing that has two readings: no modulus in a modulus, no interval or
/// integral as a factor.
std::string random_formula(int depth) {
  const auto pick = [](const std::vector<std::string>& parts) { return *rc::gen::elementOf(parts); };
  const auto inner = [&] { return depth > 0 ? random_formula(depth - 1) : pick({"x", "2", "alpha"}); };
  const auto simple = [&] { return pick({"x-c", "2", "1-2nu", "t_n + 1", "a/2"}); };
  const auto operand = [&](bool factor) -> std::string {
    switch (*rc::gen::inRange(factor ? 2 : 0, 12)) {
      case 0: return "]" + simple() + ", " + simple() + "[";
      case 1: return "int_{" + inner() + "}^" + pick({"1", "oo", "x"}) + " t dx'";
      case 2: return "(" + inner() + ")";
      case 3: return "|" + simple() + "|";
      case 4: return "sqrt(" + inner() + ")";
      case 5: return "<<" + inner() + ", " + inner() + ">>";
      case 6: return pick({"cos", "log", "max"}) + "(" + inner() + ")";
      case 7: return pick({"x", "psi", "R"}) + pick({"_bar", "_tilde", "_hat"});
      case 8: return pick({"t", "Phi", "(x)"}) + pick({"_n", "^2", "'", "_{k+1}", "^{-1/2}", "_-", "^+"});
      default: return pick({"x", "12", "0.5", "alpha", "gamma f", "P R", "Phi", "d_k", "poly"});
    }
  };
  std::string formula = pick({"", "", "-"}) + operand(false);
  const int more = *rc::gen::inRange(0, 3);
  for (int k = 0; k < more; ++k) {
    const std::string sign = pick({" + ", " - ", " ", "/", " = ", " <= ", " +- ", ", ", " * ", " in ", " -> "});
    formula += sign + operand(sign == " " || sign == "/");
  }
  return formula;
}

struct Case {
  const char* formula;
  const char* xml;
};

}  // namespace

TEST_CASE("formulas and their MathML") {
  const std::vector<Case> cases{
      {"x", "<math><mi>x</mi></math>"},
      {"2nu", "<math><mn>2</mn><mi>ν</mi></math>"},
      {"t_n", "<math><msub><mi>t</mi><mi>n</mi></msub></math>"},
      {"f_-", "<math><msub><mi>f</mi><mo>−</mo></msub></math>"},
      {"a_{i+1}", "<math><msub><mi>a</mi><mi>i</mi><mo>+</mo><mn>1</mn></msub></math>"},
      {"x^2", "<math><msup><mi>x</mi><mn>2</mn></msup></math>"},
      {"z^-1", "<math><msup><mi>z</mi><mo>−</mo><mn>1</mn></msup></math>"},
      {"p_k^2", "<math><msubsup><mi>p</mi><mi>k</mi><mn>2</mn></msubsup></math>"},
      {"psi'", "<math><msup><mi>ψ</mi><mo>′</mo></msup></math>"},
      {"u''", "<math><msup><mi>u</mi><mo>″</mo></msup></math>"},
      {"psi_bar'", "<math><msup><mover><mi>ψ</mi><mo>‾</mo></mover><mo>′</mo></msup></math>"},
      {"t_tilde_n", "<math><msub><mover><mi>t</mi><mo>˜</mo></mover><mi>n</mi></msub></math>"},
      {"sigma_xx", "<math><msub><mi>σ</mi><mi>x</mi><mi>x</mi></msub></math>"},
      {"q_poly", "<math><msub><mi>q</mi><mi>poly</mi></msub></math>"},
      {"1/2", "<math><mn>1</mn><mo>/</mo><mn>2</mn></math>"},
      {"1/2 x", "<math><mfrac><mn>1</mn><mn>2</mn></mfrac><mi>x</mi></math>"},
      {"x^{1/2}", "<math><msup><mi>x</mi><mn>1</mn><mo>/</mo><mn>2</mn></msup></math>"},
      {"P R/(2 pi)", "<math><mfrac><mi>P</mi><mi>R</mi><mn>2</mn><mi>π</mi></mfrac></math>"},
      {"a/b/c", "<math><mfrac><mi>a</mi><mi>b</mi></mfrac><mo>/</mo><mi>c</mi></math>"},
      {"cos x/2", "<math><mi>cos</mi><mi>x</mi><mo>/</mo><mn>2</mn></math>"},
      {"1/f(x)", "<math><mfrac><mn>1</mn><mi>f</mi><mo>(</mo><mi>x</mi><mo>)</mo></mfrac></math>"},
      {"1/pi (x)", "<math><mfrac><mn>1</mn><mi>π</mi></mfrac><mo>(</mo><mi>x</mi><mo>)</mo></math>"},
      {"(1/pi) x", "<math><mfrac><mn>1</mn><mi>π</mi></mfrac><mi>x</mi></math>"},
      {"f(a/2)", "<math><mi>f</mi><mo>(</mo><mfrac><mi>a</mi><mn>2</mn></mfrac><mo>)</mo></math>"},
      {"2(a/3)", "<math><mn>2</mn><mo>(</mo><mfrac><mi>a</mi><mn>3</mn></mfrac><mo>)</mo></math>"},
      {"]-1, 1/2[", "<math><mo>]</mo><mo>−</mo><mn>1</mn><mo>,</mo><mn>1</mn><mo>/</mo><mn>2</mn><mo>[</mo></math>"},
      {"[psi']", "<math><mo>[</mo><msup><mi>ψ</mi><mo>′</mo></msup><mo>]</mo></math>"},
      {"|x-c|", "<math><mo>|</mo><mi>x</mi><mo>−</mo><mi>c</mi><mo>|</mo></math>"},
      {"a|b||c|", "<math><mi>a</mi><mo>|</mo><mi>b</mi><mo>|</mo><mo>|</mo><mi>c</mi><mo>|</mo></math>"},
      {"<<t, 1>>", "<math><mo>⟨</mo><mi>t</mi><mo>,</mo><mn>1</mn><mo>⟩</mo></math>"},
      {"sqrt(1+s)", "<math><msqrt><mn>1</mn><mo>+</mo><mi>s</mi></msqrt></math>"},
      {"int_{-1}^1 t dx'",
       "<math><msubsup><mo>∫</mo><mo>−</mo><mn>1</mn><mn>1</mn></msubsup><mi>t</mi><msup><mi>d</mi>"
       "<mi>x</mi><mo>′</mo></msup></math>"},
      {"PV int t", "<math><mi>PV</mi><mo>∫</mo><mi>t</mi></math>"},
      {"x -> c-", "<math><mi>x</mi><mo>→</mo><mi>c</mi><mo>−</mo></math>"},
      {"Y+ = Y-", "<math><mi>Y</mi><mo>+</mo><mo>=</mo><mi>Y</mi><mo>−</mo></math>"},
      {"t * u <= oo", "<math><mi>t</mi><mo>∗</mo><mi>u</mi><mo>≤</mo><mi>∞</mi></math>"},
      {"3.1e-52", "<math><mn>3.1</mn><mo>×</mo><msup><mn>10</mn><mo>−</mo><mn>52</mn></msup></math>"},
      {"1e5", "<math><msup><mn>10</mn><mn>5</mn></msup></math>"},
      {"1.0e-05", "<math><msup><mn>10</mn><mo>−</mo><mn>5</mn></msup></math>"},
      {"2.0e+00", "<math><mn>2.0</mn></math>"},
      {"1.9...", "<math><mn>1.9</mn><mo>…</mo></math>"}};
  for (const Case& c : cases) {
    CAPTURE(c.formula);
    CHECK(bare(c.formula) == c.xml);
  }
}

TEST_CASE("docs/notation.md: all that it writes is a formula") {
  std::ifstream file(STEADYSLIDE_EXAMPLES "/../docs/notation.md");
  std::string line;
  while (std::getline(file, line) && line != "## Formulas in text") continue;
  std::size_t examples = 0;
  while (std::getline(file, line)) {
    if (!line.starts_with("| `")) continue;
    std::string written = std::regex_replace(line, std::regex(R"(\\\|)"), "\x01");
    written.resize(written.find('|', 1));
    std::ranges::replace(written, '\x01', '|');
    const std::regex quoted("`([^`]*)`");
    for (std::sregex_iterator match(written.begin(), written.end(), quoted), end; match != end; ++match) {
      const std::string formula = (*match)[1];
      CAPTURE(formula);
      CHECK(mathml(formula).has_value());
      ++examples;
    }
  }
  CHECK(examples > 50);
}

TEST_CASE("a long formula may break before relations and sums, and loses nothing by it") {
  const std::string formula = "b(t,t) = -(1/pi) <<t * log|x|, t>> + (1/2) sum_k (s_k - s_{k-1}) T(c_k)^2";
  const std::string xml = *mathml(formula);
  std::size_t parts = 0;
  for (std::size_t at = 0; (at = xml.find("<math>", at)) != std::string::npos; ++at) ++parts;
  CHECK(parts == 3);
  CHECK(letters_of(text_of(xml)) == expected_letters(formula));
}

TEST_CASE("what is no formula is shown as it is") {
  for (const char* text :
       {"", "((", "x^", "a /", "/ 2", "--claim", "app/a.cpp", "x]", "%", "ψ", "a_{", "x^{}", "|x", "'"}) {
    CAPTURE(text);
    CHECK_FALSE(mathml(text).has_value());
  }
  CHECK(prose("a `((` & `x` b") == "a <code>((</code> &amp; <math><mi>x</mi></math> b");
  CHECK(prose("(`x`), `y`z") ==
        "<span class=\"tie\">(<span class=\"tie\"><math><mi>x</mi></math>),</span></span> "
        "<math><mi>y</mi></math>z");
  CHECK(prose("a lone ` < b") == "a lone ` &lt; b");
  CHECK(prose("``") == "<code></code>");
  CHECK_FALSE(mathml(std::string(100000, '(')).has_value());
  CHECK_FALSE(mathml(std::string(100000, '-')).has_value());
}

TEST_CASE("formulas by the rules are typeset, well-formed, and lose no letter") {
  const bool fine = rc::check("random formulas", [] {
    const std::string formula = random_formula(2);
    RC_LOG() << formula << "\n";
    const auto typeset = mathml(formula);
    RC_ASSERT(typeset.has_value());
    RC_ASSERT(is_well_formed(*typeset));
    RC_ASSERT(letters_of(text_of(*typeset)) == expected_letters(formula));
  });
  CHECK(fine);
}

TEST_CASE("whatever stands between the backticks, the page is well-formed") {
  const std::vector<std::string> parts{"x",    "alpha", "_bar", "'",  "_",  "^",   "{",   "}", "(",  ")",
                                       "[",    "]",     "|",    "<<", ">>", "/",   "+",   "-", "+-", "*",
                                       "=",    "<=",    "<",    " ",  "12", ",",   "cos", "&", "\"", "\x01",
                                       "\xff", "ψ",     "sum",  "`",  ":",  "...", "sqrt"};
  std::size_t typeset = 0;
  const bool fine = rc::check("random texts", [&] {
    std::string text;
    for (const std::string& part : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(parts)))
      text += part;
    RC_LOG() << text << "\n";
    const std::string html = prose("`" + text + "`");
    if (html.find("<math>") != std::string::npos) ++typeset;
    RC_ASSERT(is_well_formed(html));
  });
  CHECK(fine);
  CHECK(typeset > 0);
}

TEST_CASE("control: the check of well-formedness refuses what is not") {
  for (const char* bad : {"<a><b></a></b>", "<a>", "</a>", "a & b", "a < b", "<a x=\"<\"></a>", "&nbsp;"}) {
    CAPTURE(bad);
    CHECK_FALSE(is_well_formed(bad));
  }
  CHECK(letters_of("ab") != letters_of("a"));
}
