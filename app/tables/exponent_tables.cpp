#include "app/tables/exponent_tables.hpp"

#include <algorithm>

#include "app/embedded.hpp"
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

/// The tables as exponent_tables.md has them, without rows: a heading, paragraphs, a line of columns, references.
std::vector<TextTable> empty_tables() {
  std::vector<TextTable> tables;
  std::string_view rest = embedded::exponent_tables_md;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find("\n\n"), rest.size() - 1);
    std::string block(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 2, rest.size()));
    std::ranges::replace(block, '\n', ' ');
    if (block.starts_with("## ")) {
      tables.push_back({block.substr(3), "", {}, {}, {}});
    } else if (block.starts_with('[')) {
      tables.back().references.push_back(block);
    } else if (block.starts_with('|')) {
      for (std::size_t at = 2; at < block.size(); at = block.find('|', at) + 2) {
        tables.back().columns.push_back(block.substr(at, block.find(" |", at) - at));
      }
    } else {
      tables.back().note += (tables.back().note.empty() ? "" : "\n") + block;
    }
  }
  return tables;
}

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

void fill_by_poisson(TextTable& table) {
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

void fill_constants(TextTable& table) {
  for (const auto& [name, young, poisson, shear, source] : materials()) {
    table.rows.push_back({name, young, poisson, shear.value_or("-"), source});
  }
}

Elasticity elasticity_of(const MaterialPair& pair) {
  const Solid half_plane = material(pair.half_plane).solid();
  return pair.indenter ? Elasticity(half_plane, material(*pair.indenter).solid()) : Elasticity(half_plane);
}

void fill_by_pair(TextTable& table) {
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
  std::vector<TextTable> tables = empty_tables();
  fill_by_poisson(tables.at(0));
  fill_constants(tables.at(1));
  fill_by_pair(tables.at(2));
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
