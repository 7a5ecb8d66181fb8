#include "app/report/math_row.hpp"

#include <fmt/format.h>

namespace steadyslide::app {
namespace {

using Shape = MathItem::Shape;

constexpr std::size_t short_formula = 14;  // such a one stays on a line
constexpr std::size_t short_part = 9;

bool is_operand(const MathItem& item) {
  return item.role == MathRole::operand || item.role == MathRole::function || item.role == MathRole::big;
}

/// Between neighbours that no sign separates, in em.
double space_between(const MathItem& left, const MathItem& right) {
  if (left.shape == Shape::prefix) return 0;
  if (left.role == MathRole::word || right.role == MathRole::word) return 0.3;
  if (!is_operand(left) || !is_operand(right)) return 0;
  if (left.role == MathRole::function && right.shape == Shape::group) return 0;
  if (right.shape == Shape::differential) return 0.17;
  const bool wide = left.role != MathRole::operand || right.role != MathRole::operand || left.shape == Shape::upright ||
                    left.shape == Shape::differential;
  if (wide || (right.shape == Shape::upright && right.space_before)) return 0.17;
  if (left.shape == Shape::fraction || right.shape == Shape::fraction) return 0.12;
  const bool numbers = left.shape == Shape::number && right.shape == Shape::number;
  return numbers ? 0.17 : 0;
}

std::string space_xml(const MathItem& left, const MathItem& right) {
  const double space = space_between(left, right);
  return space > 0 ? fmt::format(R"(<mspace width="{}em"/>)", space) : "";
}

bool may_break_before(const MathRow& row, std::size_t at, std::size_t width) {
  const MathItem& item = row[at];
  const MathItem& left = row[at - 1];
  if (left.shape == Shape::prefix) return false;
  if (left.role == MathRole::punctuation || item.role == MathRole::relation || item.role == MathRole::word) return true;
  if (item.role == MathRole::binary && item.shape != Shape::prefix) return width >= short_part;
  const bool factors = left.role == MathRole::operand && is_operand(item) && item.space_before;
  return factors && item.shape != Shape::differential && width >= short_formula && item.width > 3;
}

}  // namespace

std::string row_xml(const MathRow& row) {
  std::string xml;
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (k > 0) xml += space_xml(row[k - 1], row[k]);
    xml += row[k].xml;
  }
  return xml;
}

std::size_t row_width(const MathRow& row) {
  std::size_t width = 0;
  for (const MathItem& item : row) width += item.width;
  return width;
}

std::string math_element(std::string_view tag, std::initializer_list<std::string> children) {
  std::string xml;
  for (const std::string& child : children) xml += fmt::format("<mrow>{}</mrow>", child);
  return fmt::format("<{0}>{1}</{0}>", tag, xml);
}

MathItem math_operator(const MathSymbol& symbol, bool small) {
  MathItem item{"", symbol.role};
  const bool relation = symbol.role == MathRole::relation;
  if (symbol.role == MathRole::punctuation) {
    item.xml = fmt::format(R"(<mo form="infix" lspace="0" rspace="{}em">{}</mo>)", small ? 0.1 : 0.3, symbol.glyph);
  } else {
    const double space = small ? 0.08 : relation ? 0.28 : 0.22;
    item.xml =
        fmt::format(R"(<mo form="infix" stretchy="false" lspace="{0}em" rspace="{0}em">{1}</mo>)", space, symbol.glyph);
  }
  return item;
}

std::vector<MathRow> breakable(const MathRow& row) {
  if (row_width(row) <= short_formula) return {row};
  std::vector<MathRow> parts(1);
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (k > 0 && may_break_before(row, k, row_width(parts.back()))) {
      // A space at the end of a line is not seen, one at its beginning is.
      parts.back().back().xml += space_xml(row[k - 1], row[k]);
      parts.emplace_back();
    }
    parts.back().push_back(row[k]);
  }
  return parts;
}

}  // namespace steadyslide::app
