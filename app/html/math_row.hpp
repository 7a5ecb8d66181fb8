#pragma once
// A formula as MathML: its smallest parts (names, numbers, signs, brackets, scripts: math_leaves.cpp), and rows of
// these parts with the spaces between them and the places where a line may break (math_row.cpp).

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
  bool tall = false;                  ///< true if it contains a stacked fraction
  std::vector<MathItem> inside = {};  ///< the row in round brackets, if it has no scripts
};

using MathRow = std::vector<MathItem>;

MathItem number_item(std::string_view digits);
/// Returns a letter (x, alpha), a differential (dx), or a longer name, which is set upright.
MathItem name_item(std::string_view name);
/// Returns a symbol that is not an operand: a function, a word, the sign of an operation or of a relation. Signs state
/// their spaces, because a line may break before a sign, and MathML takes an operator at the beginning of a row for a
/// prefix.
MathItem symbol_item(const MathSymbol& symbol, bool small);
/// Return a sign that stands before one operand or after it: -x, c+.
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

/// Returns the XML of a name that is a script without braces: xx of sigma_xx is two letters, poly is a word.
std::string script_name(std::string_view name);

std::string row_xml(const MathRow& row);
std::size_t row_width(const MathRow& row);

/// Returns an element with exactly these children: <mfrac><mrow>..</mrow><mrow>..</mrow></mfrac>.
std::string math_element(std::string_view tag, std::initializer_list<std::string> children);

/// Returns the parts of the row. A line may break between two parts: before relations and sums, and between long
/// factors.
std::vector<MathRow> breakable(const MathRow& row);

/// Divides the factors that end the row by `denominator`. Stacks the fraction if the row is not small and both parts
/// are short; writes a solidus otherwise.
void divide(MathRow& row, MathRow denominator, bool small);

/// Removes the round brackets of the last item if they contain a stacked fraction alone: (1/pi) x becomes 1/pi x.
/// Behind a function, a number, or a name without a space the brackets stay.
void drop_idle_brackets(MathRow& row);

/// Reads a formula in the notation of docs/theory.md (math_parser.cpp). Returns nothing if the text is no formula.
std::optional<MathRow> parse_math(std::string_view formula);

}  // namespace steadyslide::app
