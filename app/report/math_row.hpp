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

/// The sign of an operation or a relation, with its spaces said: MathML takes an operator at the beginning of a row,
/// where a line may have been broken, for a prefix.
MathItem math_operator(const MathSymbol& symbol, bool small);

/// Parts of the row between which a line may break: before relations and sums, between long factors.
std::vector<MathRow> breakable(const MathRow& row);

}  // namespace steadyslide::app
