#include "app/html/math_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace steadyslide::app {
namespace {

using Shape = MathItem::Shape;

constexpr std::size_t short_formula = 14;  // a formula of at most this width is not broken
constexpr std::size_t short_part = 9;

bool is_operand(const MathItem& item) {
  return item.role == MathRole::operand || item.role == MathRole::function || item.role == MathRole::big;
}

/// Returns the space between two neighbours that no sign separates, in em.
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

constexpr std::size_t widest_numerator = 28;
constexpr std::size_t widest_denominator = 36;

/// Returns the first of the factors that end the row.
MathRow::iterator factors(MathRow& row) {
  auto begin = row.end();
  while (begin != row.begin()) {
    const MathItem& item = *std::prev(begin);
    const bool factor = item.role == MathRole::operand || item.role == MathRole::function;
    if (!factor || item.shape == Shape::fraction) break;
    --begin;
  }
  return begin;
}

/// True if a function's argument has no brackets. sin x/2 does not say whether x or sin x is halved, so that such a
/// quotient is not stacked.
bool has_bare_argument(MathRow::const_iterator begin, MathRow::const_iterator end) {
  for (auto item = begin; item != end; ++item) {
    const auto next = std::next(item);
    if (item->role == MathRole::function && (next == end || next->shape != Shape::group)) return true;
  }
  return false;
}

std::string without_brackets(const MathRow& row) {
  const bool bracketed = row.size() == 1 && !row.front().inside.empty();
  return row_xml(bracketed ? row.front().inside : row);
}

}  // namespace

std::string row_xml(const MathRow& row) {
  std::string xml;
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (k > 0) xml += space_xml(row[k - 1], row[k]);
    const std::string& item = row[k].xml;
    // A sign between two items has these spaces by default.
    const bool inside = k > 0 && k + 1 < row.size();
    const bool usual = item.starts_with(R"(<mo lspace=".22em" r)") || item.starts_with(R"(<mo lspace=".28em" r)");
    xml += inside && usual ? "<mo" + item.substr(item.find('>')) : item;
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
  for (const std::string& child : children) {
    // A single element needs no <mrow>.
    const std::string closing = "</" + child.substr(1, child.find_first_of(" >") - 1) + ">";
    const bool single = child.ends_with(closing) && child.find(closing) + closing.size() == child.size();
    xml += single ? child : fmt::format("<mrow>{}</mrow>", child);
  }
  return fmt::format("<{0}>{1}</{0}>", tag, xml);
}

std::vector<MathRow> breakable(const MathRow& row) {
  if (row_width(row) <= short_formula) return {row};
  std::vector<MathRow> parts(1);
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (k > 0 && may_break_before(row, k, row_width(parts.back()))) {
      // The space goes to the end of the line, where it is invisible. At the beginning of a line it would be visible.
      parts.back().back().xml += space_xml(row[k - 1], row[k]);
      parts.emplace_back();
    }
    parts.back().push_back(row[k]);
  }
  return parts;
}

void divide(MathRow& row, MathRow denominator, bool small) {
  const auto begin = factors(row);
  const MathRow numerator(begin, row.end());
  const std::size_t above = row_width(numerator);
  const std::size_t below = row_width(denominator);
  const bool stacks = !small && !numerator.empty() && std::ranges::none_of(numerator, &MathItem::tall) &&
                      above <= widest_numerator && below <= widest_denominator &&
                      !has_bare_argument(begin, row.end()) &&
                      !has_bare_argument(denominator.begin(), denominator.end());
  if (!stacks) {
    row.push_back({R"(<mo lspace="0" rspace="0">/</mo>)", MathRole::binary, Shape::prefix});
    std::ranges::move(denominator, std::back_inserter(row));
    return;
  }
  MathItem fraction{math_element("mfrac", {without_brackets(numerator), without_brackets(denominator)})};
  fraction.shape = Shape::fraction;
  fraction.tall = true;
  fraction.width = std::max(above, below);
  fraction.space_before = numerator.front().space_before;
  row.erase(begin, row.end());
  row.push_back(std::move(fraction));
}

void drop_idle_brackets(MathRow& row) {
  const MathItem& last = row.back();
  if (last.inside.size() != 1 || last.inside.front().shape != Shape::fraction) return;
  if (row.size() > 1) {
    const MathItem& left = row[row.size() - 2];
    const bool factor = left.role == MathRole::operand && left.shape != Shape::number && last.space_before;
    const bool sign = left.role != MathRole::operand && left.role != MathRole::function;
    if (!factor && !sign) return;
  }
  MathItem fraction = last.inside.front();
  fraction.space_before = last.space_before;
  row.back() = std::move(fraction);
}

}  // namespace steadyslide::app
