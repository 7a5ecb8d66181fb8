#include "app/tables/exponent_tables.hpp"

#include <algorithm>
#include <stdexcept>

#include "app/embedded.hpp"
#include "library/text/number_format.hpp"
#include "model/singular_point.hpp"
#include "proofs_checks/proof/markdown.hpp"

namespace steadyslide::app {
namespace {

constexpr int digits = 6;

struct Coatings {
  Rational left;
  Rational right;
};

/// Returns the tables of the section "Exponents in numbers" of docs/theory.md with their headings, paragraphs, data and
/// references. The computed columns are filled again afterwards.
std::vector<TextTable> given_tables() {
  std::vector<TextTable> tables;
  const std::string_view section = proofs_checks::section_of(embedded::theory_md, "## Exponents in numbers");
  for (const std::string& line : proofs_checks::list_of(section, "\n")) {
    if (line.starts_with("### ")) {
      tables.push_back({line.substr(4), "", {}, {}, {}});
    } else if (line.empty() || line.starts_with("| ---")) {
      continue;
    } else if (line.starts_with('[')) {
      tables.back().references.push_back(line);
    } else if (line.starts_with('|')) {
      std::vector<std::string>& columns = tables.back().columns;
      (columns.empty() ? columns : tables.back().rows.emplace_back()) = cells_of_row(line);
    } else {
      tables.back().note += (tables.back().note.empty() ? "" : "\n") + line;
    }
  }
  return tables;
}

std::string text(const Exponent& exponent) { return library::format_exponent(exponent, digits); }
std::string text(const Rational& value) { return library::format_number(value, digits); }

/// The behaviour of the traction at a friction jump with this power, if no other singularity is there.
std::string behaviour(const Exponent& beta) {
  const int sign = beta.sign();
  return sign < 0 ? "blows up" : sign > 0 ? "vanishes" : "stays finite";
}

/// The power for steady sliding to +x and back. For sliding back, s changes its sign.
Exponent jump_power(const Rational& gamma, const Coatings& f, bool forward) {
  const Exponent beta = jump_exponent(gamma * f.left, gamma * f.right);
  return forward ? beta : -beta;
}

void fill_by_poisson(TextTable& table) {
  table.rows.clear();
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
}

/// A material of the table of constants; E is in GPa.
Solid solid(const TextTable& constants, const std::string& name) {
  const auto row = std::ranges::find(constants.rows, name, [](const auto& cells) { return cells.front(); });
  if (row == constants.rows.end()) throw std::out_of_range("no such material: " + name);
  return {parse_rational(row->at(2)), parse_rational(row->at(1))};
}

/// Fills the columns behind the half-plane and the indenter, which are given.
void fill_by_pair(TextTable& table, const TextTable& constants) {
  const Coatings jump{Rational(1, 10), Rational(1, 2)};
  for (std::vector<std::string>& row : table.rows) {
    row.resize(2);
    const Solid half_plane = solid(constants, row[0]);
    const Elasticity elasticity =
        row[1] == "rigid" ? Elasticity(half_plane) : Elasticity(half_plane, solid(constants, row[1]));
    const Rational& gamma = elasticity.gamma();
    row.push_back(text(dundurs_alpha(elasticity)));
    row.push_back(text(gamma));
    for (const Rational& f : {Rational(1, 5), Rational(1, 2)}) {
      row.push_back(text(free_exponent(End::left, gamma * f)));
      row.push_back(text(free_exponent(End::right, gamma * f)));
    }
    for (const bool forward : {true, false}) {
      const Exponent beta = jump_power(gamma, jump, forward);
      row.push_back(text(beta));
      row.push_back(behaviour(beta));
    }
  }
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

std::vector<TextTable> exponent_tables() {
  std::vector<TextTable> tables = given_tables();
  fill_by_poisson(tables.at(0));
  fill_by_pair(tables.at(2), tables.at(1));
  return tables;
}

std::vector<TableDocument> exponent_documents() {
  const std::string title = "Exponents of the traction";
  const std::vector<TextTable> tables = exponent_tables();
  return {{"exponents.md", markdown_document(title, tables)},
          {"exponents.tex", latex_document(title, tables)},
          {"exponents.csv", csv_document(tables)}};
}

}  // namespace steadyslide::app
