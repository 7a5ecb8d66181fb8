// Drawings on the page: gnuplot's SVG, made small and put among others.

#include <fmt/format.h>

#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <ranges>
#include <regex>
#include <sstream>

#include "app/report/sections.hpp"

namespace steadyslide::app {
namespace {

/// The data of a path in tenths of a pixel, without the points that lie on the line through their neighbours: what is left is
/// seen as the same curve. Data of another form than "M1.00,2.00 L3.00,4.00" stay.
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
  // From each kept corner as far as all corners between lie within a fifth of a pixel of the chord.
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

void remove_elements(std::string& svg, const std::string& tag) {
  const std::string closing = "</" + tag + ">";
  std::size_t at = 0;
  while ((at = svg.find("<" + tag, at)) != std::string::npos) {
    const std::size_t after = at + 1 + tag.size();
    if (after < svg.size() && svg[after] != '>' && svg[after] != ' ' && svg[after] != '\n' && svg[after] != '/') {
      at = after;
      continue;
    }
    const std::size_t bracket = svg.find('>', at);
    const bool empty = bracket != std::string::npos && svg[bracket - 1] == '/';
    const std::size_t end = empty ? bracket : svg.find(closing, at);
    const std::size_t length = empty ? 1 : closing.size();
    svg.erase(at, end == std::string::npos ? std::string::npos : end + length - at);
  }
}

/// Without the marks that no curve has, and without the description: on the page the caption says the same.
std::string without_idle(std::string svg) {
  static const std::regex definition(R"(<(?:circle|path|rect|use)\b[^>]*\bid='([^']*)'[^>]*/>\s*)");
  remove_elements(svg, "desc");
  // From the last to the first: a mark may be made of an earlier one.
  const std::size_t end = std::min(svg.find("</defs>"), svg.size());
  std::vector<std::pair<std::string, std::string>> marks;
  const std::string head = svg.substr(0, end);
  for (std::sregex_iterator mark(head.begin(), head.end(), definition), none; mark != none; ++mark)
    marks.emplace_back(mark->str(0), "#" + mark->str(1) + "'");
  for (const auto& [mark, name] : marks | std::views::reverse) {
    if (svg.find(name) == std::string::npos) svg.erase(svg.find(mark), mark.size());
  }
  return svg;
}

}  // namespace

std::string slim_svg(std::string svg) {
  svg = without_idle(std::move(svg));
  std::string paths;
  for (std::size_t at = 0;;) {
    const std::size_t begin = svg.find(" d='", at);
    const std::size_t end = begin == std::string::npos ? begin : svg.find('\'', begin + 4);
    paths += svg.substr(at, end == std::string::npos ? end : begin + 4 - at);
    if (end == std::string::npos) break;
    paths += short_path(std::string_view(svg).substr(begin + 4, end - begin - 4));
    at = end;
  }
  std::string result;
  for (std::size_t at = 0; at < paths.size(); ++at) {
    const std::size_t next = paths.find_first_not_of(" \t\n", at);
    const bool between = result.ends_with('>') && next != std::string::npos && paths[next] == '<' &&
                         paths.substr(at, next - at).find('\n') != std::string::npos;
    if (between) at = next;
    result += paths[at] == '\n' || paths[at] == '\t' ? ' ' : paths[at];
  }
  for (const char* idle :
       {R"( stroke-linecap="butt")", R"( stroke-linejoin="miter")", "<text></text>",
        R"( font-family="Helvetica, Arial, 'Liberation Sans', sans-serif")", R"( xml:space="preserve")"})
    boost::erase_all(result, idle);
  for (std::size_t before = 0; before != result.size();) {
    before = result.size();
    std::string kept;
    for (std::size_t at = 0;;) {
      const std::size_t close = result.find("></g>", at);
      const std::size_t open = close == std::string::npos ? close : result.rfind('<', close);
      const bool empty = open != std::string::npos && result.compare(open, 2, "<g") == 0 && open >= at &&
                         std::string_view(result).substr(open, close - open).find(" id=") == std::string_view::npos;
      kept += result.substr(at, close == std::string::npos ? close : (empty ? open : close + 5) - at);
      if (close == std::string::npos) break;
      at = close + 5;
    }
    result = std::move(kept);
  }
  return result;
}

std::string inline_svg(std::string_view svg, std::string_view prefix, std::string_view title) {
  const std::size_t begin = svg.find("<svg");
  const std::size_t end = svg.rfind("</svg>");
  if (begin == std::string_view::npos || end == std::string_view::npos || end < begin) return "";
  std::string result(svg.substr(begin, end + 6 - begin));
  for (const char* tag : {"title", "script"}) remove_elements(result, tag);
  const std::string start = std::string(prefix) + "-";
  for (const char* reference : {R"( id=")", " id='", R"(href="#)", "href='#", "url(#"}) {
    boost::replace_all(result, reference, reference + start);
  }
  result.insert(4, R"( role="img" aria-label=")" + escaped(title) + R"(")");
  return result;
}

}  // namespace steadyslide::app
