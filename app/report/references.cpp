// docs/references.md as a list of the page, and citations as links into it.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ranges>
#include <regex>
#include <vector>

#include "app/embedded.hpp"
#include "app/report/mathml.hpp"
#include "app/report/sections.hpp"

namespace steadyslide::app {
namespace {

struct Reference {
  std::string key;
  std::string text;  ///< Markdown
};

std::vector<Reference> references(std::string_view markdown) {
  std::vector<Reference> found;
  bool inside = false;
  for (const auto part : std::views::split(markdown, '\n')) {
    const std::string_view line(part.begin(), part.end());
    const std::size_t close = line.find("]**");
    if (line.starts_with("**[") && close != std::string_view::npos) {
      found.push_back({std::string(line.substr(3, close - 3)), std::string(line.substr(close + 3))});
      inside = true;
    } else if (line.empty() || line.starts_with("|") || !inside) {
      inside = false;
    } else {
      found.back().text += " " + std::string(line);
    }
  }
  return found;
}

/// Emphasis and links.
std::string inline_markdown(std::string_view text) {
  static const std::regex link(R"(\[([^\]]*)\]\(([^)]*)\))");
  static const std::regex emphasis(R"(\*([^*]*)\*)");
  const std::string linked = std::regex_replace(escaped(text), link, R"(<a href="$2">$1</a>)");
  return std::regex_replace(linked, emphasis, "<em>$1</em>");
}

/// "[Key" where a comma or a bracket follows, for the keys of the list.
std::regex citation() {
  std::vector<std::string> keys;
  for (const Reference& r : references(embedded::references_md)) keys.push_back(r.key);
  return std::regex(fmt::format(R"(\[({})(?=[,\]]))", fmt::join(keys, "|")));
}

}  // namespace

std::string references_list(std::string_view markdown) {
  std::string items;
  for (const Reference& r : references(markdown)) {
    items += element("dt", "[" + escaped(r.key) + "]", {{"id", "ref-" + r.key}}) + block("dd", inline_markdown(r.text));
  }
  return items.empty() ? "" : block("dl", "\n" + items, {{"class", "references"}});
}

std::string cited_prose(std::string_view text) {
  static const std::regex known = citation();
  return std::regex_replace(prose(text), known, R"([<a href="#ref-$1">$1</a>)");
}

}  // namespace steadyslide::app
