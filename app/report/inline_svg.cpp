#include "app/report/inline_svg.hpp"

#include <boost/algorithm/string/replace.hpp>

#include "app/report/html.hpp"

namespace steadyslide::app {
namespace {

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

}  // namespace

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
