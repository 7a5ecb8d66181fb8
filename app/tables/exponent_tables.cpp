#include "app/tables/exponent_tables.hpp"

#include "app/results/exponent_text.hpp"
#include "app/results/number_format.hpp"
#include "app/tables/materials.hpp"
#include "model/singular_point.hpp"

namespace steadyslide::app {
namespace {

constexpr int digits = 6;

struct Coatings {
  Rational left;
  Rational right;
};

const std::string bal16 =
    "[Bal16] P. Ballard, Steady sliding frictional contact problem for a 2d elastic half-space with a discontinuous "
    "friction coefficient and related stress singularities, Journal of the Mechanics and Physics of Solids 97 (2016) "
    "225-259.";
const std::string dun69 =
    "[Dun69] J. Dundurs, Discussion: Edge-bonded dissimilar orthogonal elastic wedges under normal and shear loading, "
    "Journal of Applied Mechanics 36 (1969) 650-652.";
const std::string kl95 =
    "[KL95] G. W. C. Kaye, T. H. Laby, Tables of Physical and Chemical Constants, 16th edition, Longman, Harlow, 1995, "
    "section 2.2.2, Elasticities and strengths.";
const std::string ger01 =
    "[Ger01] J. M. Gere, Mechanics of Materials, 5th edition, Brooks/Cole, Pacific Grove, 2001, table H-2.";

std::string text(const Exponent& exponent) { return format_exponent(exponent, digits); }
std::string text(const Rational& value) { return format_number(value, digits); }

/// What the traction does at a friction jump with this power, where nothing else is singular.
std::string behaviour(const Exponent& beta) {
  const int sign = beta.sign();
  return sign < 0 ? "blows up" : sign > 0 ? "vanishes" : "stays finite";
}

/// Steady sliding to +x and back: back, s changes its sign.
Exponent jump_power(const Rational& gamma, const Coatings& f, bool forward) {
  const Exponent beta = jump_exponent(gamma * f.left, gamma * f.right);
  return forward ? beta : -beta;
}

TextTable by_poisson() {
  TextTable table{
      "Exponents by Poisson's ratio",
      "A rigid indenter on a half-plane in plane strain, two coatings with `f_-` on the left and `f_+` on the right of "
      "a "
      "friction jump. The traction is a power of the distance: `-1/2 - alpha_-` at an edge of the indenter at the left "
      "end of the contact, `-1/2 + alpha_+` at one at the right end, `1/2 - alpha_-` and `1/2 + alpha_+` where the "
      "contact ends freely, `alpha_- - alpha_+` at the jump, sliding to `+x`: left is the rear. All numbers are pure.\n"
      "At edges the traction blows up, at free ends it vanishes, under any friction. Sliding back to `-x`, `alpha` "
      "changes its sign in every power, so that a jump where the traction blows up becomes one where it vanishes.",
      {"`nu`", "`f_-`", "`f_+`", "`gamma`", "`alpha_-`", "`alpha_+`", "left edge", "right edge", "left free end",
       "right free end", "jump", "at the jump, to `+x`", "at the jump, to `-x`"},
      {},
      {bal16}};
  const std::vector<Coatings> coatings{{0, 1},
                                       {Rational(1, 10), Rational(1, 2)},
                                       {Rational(1, 5), Rational(3, 5)},
                                       {Rational(3, 10), 1},
                                       {Rational(1, 2), Rational(1, 2)},
                                       {Rational(1, 2), Rational(1, 10)}};
  for (const char* nu : {"0", "0.1", "0.2", "0.3", "0.4", "0.45", "0.499"}) {
    const Rational poisson = parse_rational(nu);
    const Rational gamma = Elasticity(Solid(poisson, 1)).gamma();
    for (const Coatings& f : coatings) {
      const Rational left = gamma * f.left;
      const Rational right = gamma * f.right;
      table.rows.push_back({text(poisson), text(f.left), text(f.right), text(gamma), text(Exponent::angle(left)),
                            text(Exponent::angle(right)), text(edge_exponent(End::left, left)),
                            text(edge_exponent(End::right, right)), text(free_exponent(End::left, left)),
                            text(free_exponent(End::right, right)), text(jump_power(gamma, f, true)),
                            behaviour(jump_power(gamma, f, true)), behaviour(jump_power(gamma, f, false))});
    }
  }
  return table;
}

TextTable constants() {
  TextTable table{
      "Elastic constants of the materials",
      "Isotropic solids at room temperature. The values of [KL95] are as they are quoted from it; they were "
      "not compared with the book. In each of its rows `E = 2 mu (1+nu)` within 0.4 percent. Of the ranges in "
      "[Ger01] one value each: nylon from 2.1 to 3.4 GPa, rubber from 0.0007 to 0.004 GPa and from 0.45 to "
      "0.50.",
      {"material", "`E` in GPa", "`nu`", "`mu` in GPa", "source"},
      {},
      {kl95, ger01}};
  for (const Material& m : materials())
    table.rows.push_back({m.name, m.young, m.poisson, m.shear.value_or("-"), m.source});
  return table;
}

Elasticity elasticity_of(const MaterialPair& pair) {
  const Solid half_plane = material(pair.half_plane).solid();
  return pair.indenter ? Elasticity(half_plane, material(*pair.indenter).solid()) : Elasticity(half_plane);
}

TextTable by_pair() {
  TextTable table{
      "Exponents by pairs of materials",
      "Plane strain; the first material is the half-plane, the second the indenter. `gamma` is Dundurs' second "
      "constant "
      "(his `beta`), for a rigid indenter `(1-2nu)/(2(1-nu))`; it is negative where `(1-2nu)/mu` is the larger one of "
      "the indenter, and everything then turns round with the sense of sliding. Powers of the distance to a free end "
      "of "
      "the contact, `1/2 - alpha` on the left and `1/2 + alpha` on the right, sliding to `+x`; sliding to `-x` they "
      "change places. The traction vanishes there.\n"
      "The jump lies between a coating with `f = 0.1` on the left and one with `f = 0.5` on the right, too thin to "
      "change "
      "the elastic constants. All numbers are pure.\n"
      "An elastic indenter is a half-plane to its own contact, too: that holds for smooth profiles only, and there are "
      "no "
      "edges. Under a rigid one there are; their powers are those of the free ends less 1.",
      {"half-plane", "indenter", "Dundurs' `alpha`", "`gamma`", "left, `f = 0.2`", "right, `f = 0.2`",
       "left, `f = 0.5`", "right, `f = 0.5`", "jump, to `+x`", "there", "jump, to `-x`", "there"},
      {},
      {bal16, dun69}};
  const Coatings jump{Rational(1, 10), Rational(1, 2)};
  for (const MaterialPair& pair : material_pairs()) {
    const Elasticity elasticity = elasticity_of(pair);
    const Rational& gamma = elasticity.gamma();
    std::vector<std::string> row{pair.half_plane, pair.indenter.value_or("rigid"), text(dundurs_alpha(elasticity)),
                                 text(gamma)};
    for (const Rational& f : {Rational(1, 5), Rational(1, 2)}) {
      row.push_back(text(free_exponent(End::left, gamma * f)));
      row.push_back(text(free_exponent(End::right, gamma * f)));
    }
    for (const bool forward : {true, false}) {
      const Exponent beta = jump_power(gamma, jump, forward);
      row.push_back(text(beta));
      row.push_back(behaviour(beta));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Rational dundurs_alpha(const Elasticity& elasticity) {
  if (!elasticity.indenter()) return 1;
  const auto compliance = [&](const Solid& body) {
    return Rational((body.kolosov(elasticity.plane()) + 1) / body.shear_modulus());
  };
  const Rational half_plane = compliance(elasticity.half_space().value());
  const Rational indenter = compliance(*elasticity.indenter());
  return (half_plane - indenter) / (half_plane + indenter);
}

std::vector<TextTable> exponent_tables() { return {by_poisson(), constants(), by_pair()}; }

std::vector<TableDocument> exponent_documents() {
  const std::string title = "Exponents of the traction";
  const std::vector<TextTable> tables = exponent_tables();
  return {{"exponents.md", markdown_document(title, tables)},
          {"exponents.tex", latex_document(title, tables)},
          {"exponents.csv", csv_document(tables)}};
}

}  // namespace steadyslide::app
