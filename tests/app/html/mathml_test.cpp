#include <cctype>
#include <nlohmann/json.hpp>
#include <numeric>
#include <regex>

#include "app/html/math_symbols.hpp"
#include "app/html/mathml.hpp"
#include "app/svg.hpp"
#include "library/text/utf8.hpp"
#include "proofs_checks/proof/markdown.hpp"

using namespace steadyslide::app;

namespace {

/// Removes attributes of spaces and forms, and rows, so that a person can read the tables of cases.
std::string bare(std::string_view formula) {
  const auto typeset = mathml(formula);
  if (!typeset) return "none";
  std::string xml = std::regex_replace(*typeset, std::regex("</?mrow>|<mspace[^>]*/>"), "");
  xml = std::regex_replace(xml, std::regex("<(\\w+) [^>]*>"), "<$1>");
  // Brackets are operators if they stretch, and identifiers if they must not.
  return std::regex_replace(xml, std::regex("<mi>([()|[]|]|⟨|⟩)</mi>"), "<mo>$1</mo>");
}

/// Returns the visible text.
std::string text_of(const std::string& xml) { return std::regex_replace(xml, std::regex("<[^>]*>"), ""); }

/// Returns the letters and digits of a text, Latin and Greek, sorted: sub- and superscripts may change places.
std::string letters_of(std::string_view text) {
  std::vector<std::string> letters;
  for (; !text.empty();) {
    const library::Utf8Character c = library::first_character(text);
    const bool latin = c.code < 0x80 && std::isalnum(static_cast<unsigned char>(text.front())) != 0;
    const bool greek = c.code >= 0x370 && c.code < 0x400;
    if (latin || greek) letters.emplace_back(text.substr(0, c.length));
    text.remove_prefix(std::max<std::size_t>(c.length, 1));
  }
  std::ranges::sort(letters);
  return std::accumulate(letters.begin(), letters.end(), std::string());
}

std::string glyph_of(const std::string& name) {
  const auto symbol = math_name(name);
  return symbol ? std::string(symbol->glyph) : name;
}

/// Returns the letters of a formula that must be visible on the page: its names by their glyphs, and its numbers.
std::string expected_letters(std::string_view formula) {
  std::string text;
  const std::vector<MathToken> tokens = math_tokens(formula).value();
  for (const MathToken& token : tokens) {
    const bool accent = math_accent(token.text).has_value(), drawn = token.text == "sqrt";
    if (token.kind == MathToken::Kind::number) text += token.text;
    if (token.kind != MathToken::Kind::name || accent || drawn) continue;
    const bool differential = token.text.size() > 1 && token.text.front() == 'd' && !math_name(token.text);
    text += differential ? "d" + glyph_of(token.text.substr(1)) : glyph_of(token.text);
  }
  return letters_of(text);
}

/// Returns a random formula by the rules of the notation, without ambiguity: no modulus in a modulus, no interval or
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

}  // namespace

TEST_CASE("formulas and their MathML") {
  // Formulas between backticks, each with its MathML without rows, spaces and forms.
  const auto table = nlohmann::ordered_json::parse(file_text(STEADYSLIDE_TESTS "/app/html/formulas.json"));
  CHECK(table.size() >= 41);
  for (const auto& row : table.items()) CHECK_MESSAGE(bare(row.key()) == row.value(), row.key());
}

TEST_CASE("docs/theory.md: every formula in the table of notations can be read") {
  const std::string text = file_text(STEADYSLIDE_DOCS "/theory.md");
  const std::string_view table = steadyslide::proofs_checks::section_of(text, "## Formulas in text");
  std::size_t examples = 0;
  for (const std::string& line : lines(std::string(table))) {
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

TEST_CASE("a long formula may break before relations and sums, and keeps all its letters") {
  const std::string formula = "b(t,t) = -(1/pi) <<t * log|x|, t>> + (1/2) sum_k (s_k - s_{k-1}) T(c_k)^2";
  const std::string xml = *mathml(formula);
  CHECK(times(xml, "<math>") == 3);
  CHECK(letters_of(text_of(xml)) == expected_letters(formula));
}

TEST_CASE("text that is no formula is shown as it is") {
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

TEST_CASE("a long number is cut, and its title has all digits") {
  CHECK(*mathml("0.09688167321743") == "<math><mn title=\"0.09688167321743\">0.0968816…</mn></math>");
  CHECK(*mathml("0.096881673217") == "<math><mn>0.096881673217</mn></math>");
}

TEST_CASE("formulas between backticks become plain HTML in one line") {
  for (const auto& [words, html] : std::vector<std::pair<std::string, std::string>>{
           {"the sign of `alpha` exchanged", "the sign of <i>α</i> exchanged"},
           {"difference `1.0e-44` at `nu = 1/3`, `f = 2`",
            "difference 10<sup>−44</sup> at <i>ν</i> = 1/3, <i>f</i> = 2"},
           {"`(1+x)^{1/2}` instead of `f_-`", "(1+<i>x</i>)<sup>1/2</sup> instead of <i>f</i><sub>−</sub>"},
           {"a two-sided near miss; and/or", "a two-sided near miss; and/or"},
           {"[Bal16, (4)] and (5)-(7) of theorem 3", "[Bal16, (4)] and (5)-(7) of theorem 3"},
           {"`A t = 0` on a step, `int t = -P`", "<i>A t</i> = 0 on a step, ∫ <i>t</i> = −<i>P</i>"},
           {"`PV int_0^1 e^-B` over `<<psi, t>>`",
            "PV ∫<sub>0</sub><sup>1</sup> <i>e</i><sup>−<i>B</i></sup> over ⟨<i>ψ</i>, <i>t</i>⟩"},
           {"`(4 nu - 1)` at generic points", "(4 <i>ν</i> − 1) at generic points"},
           {"without `sqrt(1+s^2)`", "without √<span class=\"root\">1+<i>s</i><sup>2</sup></span>"},
           {"`x^2/2`, and `y^2`", "<i>x</i><sup>2</sup>/2, and <i>y</i><sup>2</sup>"},
           {"from `-1` to 2-3, `a < b`, x < y", "from −1 to 2-3, <i>a</i> &lt; <i>b</i>, x &lt; y"},
           {"`x^2` & `1/f`, `sqrt(x)`", "<i>x</i><sup>2</sup> &amp; 1/<i>f</i>, √<span class=\"root\"><i>x</i></span>"},
           {"`u_bar_n'` and `sum_k c_k^2/k`, `c_{k_1}`",
            "<i>u\u0304<sub>n</sub></i>′ and ∑<sub><i>k</i></sub> <i>c<sub>k</sub></i><sup>2</sup>/<i>k</i>, "
            "<i>c</i><sub><i>k</i><sub>1</sub></sub>"},
           {"`x in (0, 1]`, `sqrt(x)^2`, `x^(1/2)`",
            "<i>x</i> ∈ (0, 1], √<span class=\"root\">(<i>x</i>)<sup>2</sup></span>, <i>x</i><sup>(1/2)</sup>"},
           {"no `((`", "no <code>((</code>"},
           {"a lone ` b", "a lone ` b"}}) {
    CHECK(lined(words) == html);
  }
  CHECK(holds(prose("`A punch-any-jumps = 0`"), "<mi>punch-any-jumps</mi>"));
}

TEST_CASE("random formulas are typeset as well-formed XML and keep all their letters") {
  CHECK(rc::check("random formulas", [] {
    const std::string formula = random_formula(2);
    RC_LOG() << formula << "\n";
    const auto typeset = mathml(formula);
    RC_ASSERT(typeset.has_value());
    RC_ASSERT(is_well_formed(*typeset));
    RC_ASSERT(letters_of(text_of(*typeset)) == expected_letters(formula));
    const std::string line = lined("`" + formula + "`");
    RC_ASSERT(!holds(line, "<math>") && !holds(line, "<code>"));
    RC_ASSERT(is_well_formed(line));
    RC_ASSERT(letters_of(text_of(line)) == expected_letters(formula));
  }));
}

TEST_CASE("the page is well-formed for any text between the backticks") {
  const std::vector<std::string> parts{"x",    "alpha", "_bar", "'",  "_",  "^",   "{",   "}", "(",  ")",
                                       "[",    "]",     "|",    "<<", ">>", "/",   "+",   "-", "+-", "*",
                                       "=",    "<=",    "<",    " ",  "12", ",",   "cos", "&", "\"", "\x01",
                                       "\xff", "ψ",     "sum",  "`",  ":",  "...", "sqrt"};
  std::size_t typeset = 0;
  CHECK(rc::check("random texts", [&] {
    std::string text;
    for (const std::string& part : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(parts)))
      text += part;
    RC_LOG() << text << "\n";
    const std::string html = prose("`" + text + "`");
    if (holds(html, "<math>")) ++typeset;
    RC_ASSERT(is_well_formed(html));
  }));
  CHECK(typeset > 0);
}

TEST_CASE("control: the check of well-formedness refuses bad XML") {
  for (const char* bad :
       {"<a><b></a></b>", "<a>", "</a>", "a & b", "a < b", "<a x=\"<\"></a>", "<a x=y/>", "<a x/>", "&nbsp;"}) {
    CAPTURE(bad);
    CHECK_FALSE(is_well_formed(bad));
  }
  CHECK(is_well_formed("<a x=\"y\" z='\"'><b/>&amp;</a>"));
  CHECK(letters_of("ab") != letters_of("a"));
}
