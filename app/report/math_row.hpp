#pragma once
// A row of a formula, element after element, as MathML: the spaces between them and the places where a line may break.

#include <string>
#include <vector>

#include "app/report/math_symbols.hpp"

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

/// A formula in the notation of docs/notation.md, read (math_parser.cpp); nothing for a text that is none.
std::optional<MathRow> parse_math(std::string_view formula);

}  // namespace steadyslide::app
