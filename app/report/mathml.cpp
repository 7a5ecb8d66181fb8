#include "app/report/mathml.hpp"

#include "app/report/html.hpp"
#include "app/report/math_parser.hpp"

namespace steadyslide::app {

std::optional<std::string> mathml(std::string_view formula) {
  const std::optional<MathRow> row = parse_math(formula);
  if (!row) return std::nullopt;
  std::string result;
  for (const MathRow& part : breakable(*row)) result += element("math", row_xml(part));
  return result;
}

std::string prose(std::string_view text) {
  std::string html;
  while (true) {
    const std::size_t begin = text.find('`');
    const std::size_t end = begin == std::string_view::npos ? begin : text.find('`', begin + 1);
    if (end == std::string_view::npos) return html + escaped(text);
    html += escaped(text.substr(0, begin));
    const std::string_view formula = text.substr(begin + 1, end - begin - 1);
    const auto typeset = mathml(formula);
    html += typeset ? *typeset : element("code", escaped(formula));
    text.remove_prefix(end + 1);
  }
}

}  // namespace steadyslide::app
