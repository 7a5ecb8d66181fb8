#include "app/report/math_fraction.hpp"

#include <algorithm>
#include <iterator>

namespace steadyslide::app {
namespace {

using Shape = MathItem::Shape;

constexpr std::size_t widest_numerator = 28;
constexpr std::size_t widest_denominator = 36;

/// Where the factors before the end of the row begin.
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

/// sin x/2 does not say whether x or sin x is halved: it stays as it is written.
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
    row.push_back(
        {R"(<mo form="infix" stretchy="false" lspace="0" rspace="0">/</mo>)", MathRole::binary, Shape::prefix});
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
