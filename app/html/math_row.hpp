#pragma once
// A formula as MathML: its smallest parts (names, numbers, signs, brackets, scripts: math_leaves.cpp), and a row of them
// (math_row.cpp) with the spaces between them and the places where a line may break.

#include <string>
#include <string_view>
#include <vector>

#include "app/html/math_symbols.hpp"

namespace steadyslide::app {

struct MathItem {
  enum class Shape { plain, number, upright, group, fraction, differential, prefix };

  std::string xml;
  MathRole role = MathRole::operand;
  Shape shape = Shape::plain;
  std::size_t width = 1;  ///< in characters, roughly
  bool space_before = false;
  bool tall = false;                  ///< with a stacked fraction in it
  std::vector<MathItem> inside = {};  ///< of a group in round brackets that has no scripts
};

using MathRow = std::vector<MathItem>;

MathItem number_item(std::string_view digits);
/// A letter, alpha, dx, or a longer name, which is set upright.
MathItem name_item(std::string_view name);
/// What is no operand: a function, a word, the sign of an operation or a relation. Signs say their spaces: MathML takes
/// an operator at the beginning of a row, where a line may have been broken, for a prefix.
MathItem symbol_item(const MathSymbol& symbol, bool small);
/// A sign before an operand, or after one: -x, c+.
MathItem prefix_item(const MathSymbol& symbol);
MathItem postfix_item(const MathSymbol& symbol);
MathItem group_item(std::string_view open, MathRow row, std::string_view close);

struct Scripts {
  std::vector<std::string> sub, sup;
  std::size_t primes = 0;

  bool empty() const { return sub.empty() && sup.empty() && primes == 0; }
};
MathItem scripted(MathItem base, const Scripts& scripts);
MathItem accented(MathItem base, std::string_view accent);

/// A name inside a script, without braces: xx of sigma_xx is two letters, poly a word.
std::string script_name(std::string_view name);

std::string row_xml(const MathRow& row);
std::size_t row_width(const MathRow& row);

/// An element with a child for each row: <mfrac><mrow>..</mrow><mrow>..</mrow></mfrac>.
std::string math_element(std::string_view tag, std::initializer_list<std::string> children);

/// Parts of the row between which a line may break: before relations and sums, between long factors.
std::vector<MathRow> breakable(const MathRow& row);

/// Divides the last factors of the row, of which there is one at least: one above the other where the row is not small
/// and the parts are short, with a solidus otherwise.
void divide(MathRow& row, MathRow denominator, bool small);

/// (1/pi) x as 1/pi x, where the last element is a bracket around nothing but a stacked fraction.
void drop_idle_brackets(MathRow& row);

/// A formula in the notation of docs/theory.md, read (math_parser.cpp); nothing for a text that is none.
std::optional<MathRow> parse_math(std::string_view formula);

}  // namespace steadyslide::app
