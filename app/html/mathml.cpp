#include "app/html/mathml.hpp"

#include <algorithm>

#include "app/html/html.hpp"
#include "app/html/math_row.hpp"

namespace steadyslide::app {

std::optional<std::string> mathml(std::string_view formula) {
  const std::optional<MathRow> row = parse_math(formula);
  if (!row) return std::nullopt;
  std::string result;
  for (const MathRow& part : breakable(*row)) result += element("math", row_xml(part));
  return result;
}

namespace {

/// Return the number of characters beside a formula that must stay with it: opening() at the end of the text before it,
/// closing() at the beginning of the text behind it. A line may not break between a formula and its comma.
std::size_t opening(std::string_view text) {
  const std::size_t last = text.find_last_not_of("([");
  return text.size() - (last == std::string_view::npos ? 0 : last + 1);
}
std::size_t closing(std::string_view text) { return std::min(text.find_first_not_of(".,;:)]!?"), text.size()); }

std::string tied(const std::string& before, std::string maths, const std::string& after) {
  if (!after.empty()) {
    const std::size_t last = maths.rfind("<math>");
    maths = maths.substr(0, last) + "<span class=\"tie\">" + maths.substr(last) + after + "</span>";
  }
  if (before.empty()) return maths;
  const std::size_t first = maths.find("</math>") + 7;
  // There is one <math> element alone: `before` goes around the span that it has already.
  if (maths.find("<span") < first) return "<span class=\"tie\">" + before + maths + "</span>";
  return "<span class=\"tie\">" + before + maths.substr(0, first) + "</span>" + maths.substr(first);
}

}  // namespace

std::string prose(std::string_view text) {
  std::string html;
  while (true) {
    const std::size_t begin = text.find('`');
    const std::size_t end = begin == std::string_view::npos ? begin : text.find('`', begin + 1);
    if (end == std::string_view::npos) return html + escaped(text);
    const std::string_view formula = text.substr(begin + 1, end - begin - 1);
    std::string_view before = text.substr(0, begin);
    text.remove_prefix(end + 1);
    if (const auto maths = mathml(formula)) {
      const std::size_t open = opening(before);
      const std::size_t close = closing(text);
      const std::string whole =
          tied(escaped(before.substr(before.size() - open)), *maths, escaped(text.substr(0, close)));
      const bool parts = maths->rfind("<math>") > 0;
      html += escaped(before.substr(0, before.size() - open)) + (parts ? span("f", whole) : whole);
      text.remove_prefix(close);
    } else {
      html += escaped(before) + code(formula);
    }
  }
}

}  // namespace steadyslide::app
