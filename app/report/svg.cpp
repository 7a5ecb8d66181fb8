// The drawings of the page: makes gnuplot's SVG smaller, and prepares it for a page with several drawings.

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <regex>
#include <sstream>
#include <vector>

#include "app/report/sections.hpp"

namespace steadyslide::app {
namespace {

/// Returns the data of a path, rounded to tenths of a pixel, without the points that lie within a fifth of a pixel of a
/// straight line. To the eye the curve stays the same. Data of another form than "M1.00,2.00 L3.00,4.00" stay as they
/// are.
std::string short_path(std::string_view data) {
  struct Corner {
    char command;
    double x, y;
  };
  std::vector<Corner> corners;
  std::istringstream stream{std::string(data)};
  for (Corner c{}; stream >> c.command;) {
    char comma = 0;
    if ((c.command != 'M' && c.command != 'L') || !(stream >> c.x >> comma >> c.y) || comma != ',')
      return std::string(data);
    corners.push_back(c);
  }
  // From each kept corner, the next kept corner is as far away as possible: all corners between them must lie within a
  // fifth of a pixel of the chord.
  const auto is_straight = [&](std::size_t from, std::size_t to) {
    const double dx = corners[to].x - corners[from].x, dy = corners[to].y - corners[from].y,
                 length = std::hypot(dx, dy);
    for (std::size_t k = from + 1; k < to; ++k) {
      const double x = corners[k].x - corners[from].x, y = corners[k].y - corners[from].y;
      const double along = (x * dx + y * dy), across = std::abs(x * dy - y * dx);
      if (along < 0 || along > length * length || across > 0.2 * length) return false;
    }
    return true;
  };
  std::string result;
  for (std::size_t k = 0; k < corners.size();) {
    result += fmt::format("{}{:.4g},{:.4g}", corners[k].command, std::round(corners[k].x * 10) / 10,
                          std::round(corners[k].y * 10) / 10);
    std::size_t next = k + 1;
    while (next + 1 < corners.size() && corners[next].command == 'L' && corners[next + 1].command == 'L' &&
           is_straight(k, next + 1))
      ++next;
    k = next;
  }
  return result;
}

std::string without(const std::string& svg, const std::string& pattern) {
  return std::regex_replace(svg, std::regex(pattern), "");
}
std::string without_element(const std::string& svg, const std::string& tag) {
  return without(svg, fmt::format(R"(<{0}(?:\s[^>]*)?(?:/>|>[^<]*</{0}>))", tag));
}

/// Removes the marks that no curve uses and the filters that no text uses, from the last one to the first: a mark may
/// use an earlier one.
std::string without_idle_definitions(std::string svg) {
  static const std::regex definition(R"((?:<(?:circle|path|rect|use)\b[^>]*\bid='([^']*)'[^>]*/>|)"
                                     R"(<filter\b[^>]*\bid='([^']*)'[^>]*>\s*(?:<fe[^>]*>\s*)*</filter>)\s*)");
  const std::string head = svg.substr(0, svg.find("</defs>"));
  const std::vector<std::smatch> found(std::sregex_iterator(head.begin(), head.end(), definition), {});
  for (auto one = found.rbegin(); one != found.rend(); ++one) {
    const std::string use = one->str(1).empty() ? "url(#" + one->str(2) + ")" : "#" + one->str(1) + "'";
    if (svg.find(use) == std::string::npos) boost::erase_first(svg, one->str(0));
  }
  return svg;
}

std::string with_short_paths(std::string svg) {
  for (std::size_t at = 0; (at = svg.find(" d='", at)) != std::string::npos;) {
    at += 4;
    const std::size_t length = svg.find('\'', at) - at;
    const std::string data = short_path(svg.substr(at, length));
    svg.replace(at, length, data);
  }
  return svg;
}

}  // namespace

std::string slim_svg(std::string svg) {
  svg = with_short_paths(without_idle_definitions(without_element(svg, "desc")));
  svg = std::regex_replace(svg, std::regex(R"(>\s*\n\s*<)"), "><");
  std::ranges::replace_if(
      svg, [](char c) { return c == '\n' || c == '\t'; }, ' ');
  for (const char* idle :
       {R"( stroke-linecap="butt")", R"( stroke-linejoin="miter")", "<text></text>",
        R"( font-family="Helvetica, Arial, 'Liberation Sans', sans-serif")", R"( xml:space="preserve")"})
    boost::erase_all(svg, idle);
  svg = std::regex_replace(svg, std::regex(R"(<tspan\s*>([^<]*)</tspan>)"), "$1");
  // Removes empty groups. This may leave other groups empty, so it is repeated until nothing changes.
  for (std::size_t before = 0; before != svg.size();) {
    before = svg.size();
    svg = without(svg, R"(<g(?:\s(?!id=)[^>\s]*)*></g>)");
  }
  return svg;
}

std::string inline_svg(std::string_view svg, std::string_view prefix, std::string_view title) {
  const std::size_t begin = svg.find("<svg");
  const std::size_t end = svg.rfind("</svg>");
  if (begin == std::string_view::npos || end == std::string_view::npos || end < begin) return "";
  std::string result(svg.substr(begin, end + 6 - begin));
  for (const char* tag : {"title", "script"}) result = without_element(result, tag);
  const std::string start = std::string(prefix) + "-";
  for (const char* reference : {R"( id=")", " id='", R"(href="#)", "href='#", "url(#"}) {
    boost::replace_all(result, reference, reference + start);
  }
  result.insert(4, R"( role="img" aria-label=")" + escaped_attribute(title) + R"(")");
  return result;
}

}  // namespace steadyslide::app
