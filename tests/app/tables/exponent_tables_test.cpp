// The section "Exponents in numbers" of docs/theory.md is computed. Its numbers agree with the formulas, evaluated here
// with 50 digits from the printed data only.

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <regex>

#include "app/tables/exponent_tables.hpp"
#include "proofs_checks/proof/markdown.hpp"
#include "support/test.hpp"

using namespace steadyslide::app;
using Float50 = boost::multiprecision::cpp_bin_float_50;

namespace {

using Row = std::vector<std::string>;

Float50 angle(const Float50& s) { return atan(s) / boost::math::constants::pi<Float50>(); }

/// Compares with the value rounded to six digits.
bool is(const std::string& text, const Float50& value) {
  if (value == 0) return text == "0";
  const Float50 unit = pow(Float50(10), floor(log10(abs(value))) - 5);
  return abs(Float50(text) - value) <= unit * Float50("0.500001");
}

std::string word(const Float50& beta) { return beta < 0 ? "blows up" : beta > 0 ? "vanishes" : "stays finite"; }

const std::vector<TextTable>& tables() {
  static const std::vector<TextTable> all = exponent_tables();
  return all;
}

/// E in GPa and nu, as the table of constants prints them.
struct Material {
  Float50 young, poisson;
};
Material material(const std::string& name) {
  for (const Row& row : tables()[1].rows) {
    if (row[0] == name) return {Float50(row[1]), Float50(row[2])};
  }
  FAIL("no such material: " << name);
  return {};
}

/// Dundurs' constants as quotients of compliances, without Kolosov's constant [Joh85, (5.3)]: G = E/(2(1+nu)).
struct Dundurs {
  Float50 alpha, beta;
};
Dundurs dundurs(const Material& one, const Material& two) {
  const auto over_shear = [](const Material& m, const Float50& factor) {
    return factor * 2 * (1 + m.poisson) / m.young;
  };
  const Float50 a1 = over_shear(one, 1 - one.poisson), a2 = over_shear(two, 1 - two.poisson);
  const Float50 b1 = over_shear(one, 1 - 2 * one.poisson), b2 = over_shear(two, 1 - 2 * two.poisson);
  return {(a1 - a2) / (a1 + a2), (b1 - b2) / (2 * (a1 + a2))};
}

}  // namespace

TEST_CASE("docs/theory.md holds the output of exponent-tables, byte by byte except for the level of headings") {
  const std::string page = file_text(STEADYSLIDE_DOCS "/theory.md");
  const std::string document = exponent_documents().front().text;
  const std::string tables = std::regex_replace(document.substr(document.find("\n## ")), std::regex("\n## "), "\n### ");
  CHECK(steadyslide::proofs_checks::section_of(page, "## Exponents in numbers") == tables);
}

TEST_CASE("exponent tables: every row has its cells, and no row occurs twice") {
  REQUIRE(tables().size() == 3);
  for (const TextTable& t : tables()) {
    CAPTURE(t.title);
    CHECK(std::set<Row>(t.rows.begin(), t.rows.end()).size() == t.rows.size());
    CHECK_FALSE(t.references.empty());
    for (const Row& row : t.rows) CHECK(row.size() == t.columns.size());
  }
  CHECK(tables()[0].rows.size() == 7 * 6);
  CHECK(tables()[2].rows.size() >= 12);
}

TEST_CASE("exponents by Poisson's ratio, all rows by 50-digit arithmetic") {
  const Float50 half = Float50(1) / 2;
  std::set<std::string> words;
  for (const Row& row : tables()[0].rows) {
    const Float50 nu(row[0]);
    const Float50 gamma = (1 - 2 * nu) / (2 * (1 - nu)), left = angle(gamma * Float50(row[1]));
    const Float50 right = angle(gamma * Float50(row[2]));
    const std::vector<Float50> expected{gamma,         left,        right,        -half - left,
                                        -half + right, half - left, half + right, left - right};
    for (std::size_t k = 0; k < expected.size(); ++k) CHECK_MESSAGE(is(row[3 + k], expected[k]), row[3 + k]);
    CHECK(row[11] == word(left - right));
    CHECK(row[12] == word(right - left));
    words.insert(row[11]);
  }
  CHECK(words.size() == 3);
}

TEST_CASE(
    "exponents by pairs of materials, all rows by 50-digit arithmetic and other formulas for Dundurs' constants") {
  const Float50 half = Float50(1) / 2;
  int negative = 0;
  for (const Row& row : tables()[2].rows) {
    CAPTURE(row[0]);
    CAPTURE(row[1]);
    const Material body = material(row[0]);
    const Float50& nu = body.poisson;
    const Dundurs constants =
        row[1] == "rigid" ? Dundurs{1, (1 - 2 * nu) / (2 * (1 - nu))} : dundurs(body, material(row[1]));
    const Float50& gamma = constants.beta;
    const Float50 low = angle(gamma / 5), high = angle(gamma / 2);
    const Float50 beta = angle(gamma / 10) - angle(gamma / 2);
    const std::vector<std::pair<std::size_t, Float50>> expected{
        {2, constants.alpha}, {3, gamma},       {4, half - low}, {5, half + low},
        {6, half - high},     {7, half + high}, {8, beta},       {10, -beta}};
    for (const auto& cell : expected) CHECK_MESSAGE(is(row[cell.first], cell.second), cell.first);
    CHECK(row[9] == word(beta));
    CHECK(row[11] == word(-beta));
    if (gamma < 0) ++negative;
    // The control: with the bodies exchanged, or without the factor 1/2, the number differs.
    if (row[1] != "rigid" && gamma != 0) {
      CHECK_FALSE(is(row[3], dundurs(material(row[1]), body).beta));
      CHECK_FALSE(is(row[3], 2 * gamma));
    }
  }
  CHECK(negative >= 2);
}

TEST_CASE("materials: E = 2 mu (1 + nu) within 0.4 percent where the source gives all three") {
  int checked = 0;
  for (const Row& row : tables()[1].rows) {
    CAPTURE(row[0]);
    if (row[3] == "-") continue;
    ++checked;
    const Float50 young(row[1]);
    CHECK(abs(2 * Float50(row[3]) * (1 + Float50(row[2])) - young) <= young * Float50("0.004"));
  }
  CHECK(checked >= 9);
}

TEST_CASE("a text table in three formats") {
  const TextTable t{"T of `nu`", "One, `alpha_-`.\nTwo: 50 %.", {"a", "`f_+`"}, {{"1, 2", "-0.5"}}, {"[Bal16] P. B."}};
  CHECK(markdown_document("D", {t}) ==
        "# D\n\n## T of `nu`\n\nOne, `alpha_-`.\n\nTwo: 50 %.\n\n| a | `f_+` |\n| --- | --- |\n| 1, 2 | -0.5 "
        "|\n\n[Bal16] P. B.\n");
  CHECK(csv_document({t}) == "table,row,column,value\nT of nu,1,a,\"1, 2\"\nT of nu,1,f_+,-0.5\n");
  const std::string latex = latex_document("D", {t});
  for (const char* part : {"\\subsection*{T of $\\nu $}", "One, $\\alpha _{-}$.\n\nTwo: 50 \\%.",
                           "a & $f_{+}$ \\\\ \\hline", "1, 2 & $-0.5$ \\\\\n\\end{longtable}}"}) {
    CHECK_MESSAGE(holds(latex, part), part);
  }
}
