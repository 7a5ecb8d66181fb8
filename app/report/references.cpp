#include "app/report/references.hpp"

#include <algorithm>
#include <vector>

#include "app/embedded.hpp"
#include "app/report/mathml.hpp"

namespace steadyslide::app {
namespace {

struct Reference {
  std::string key;
  std::string text;  ///< Markdown
};

std::vector<Reference> references(std::string_view markdown) {
  std::vector<Reference> found;
  bool inside = false;
  while (!markdown.empty()) {
    const std::size_t end = std::min(markdown.find('\n'), markdown.size());
    const std::string_view line = markdown.substr(0, end);
    markdown.remove_prefix(std::min(end + 1, markdown.size()));
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

std::string inline_markdown(std::string_view text) {
  std::string html;
  bool emphasis = false;
  while (!text.empty()) {
    const std::size_t at = std::min(text.find_first_of("*["), text.size());
    html += escaped(text.substr(0, at));
    text.remove_prefix(at);
    if (text.empty()) break;
    const std::size_t middle = text.find("](");
    const std::size_t end = text.find(')', std::min(middle, text.size()));
    if (text.front() == '*') {
      emphasis = !emphasis;
      html += emphasis ? "<em>" : "</em>";
      text.remove_prefix(1);
    } else if (end == std::string_view::npos) {
      html += "[";
      text.remove_prefix(1);
    } else {
      html += element("a", escaped(text.substr(1, middle - 1)), {{"href", text.substr(middle + 2, end - middle - 2)}});
      text.remove_prefix(end + 1);
    }
  }
  return emphasis ? html + "</em>" : html;
}

const std::vector<Reference>& known() {
  static const std::vector<Reference> all = references(embedded::references_md);
  return all;
}

}  // namespace

std::string references_list(std::string_view markdown) {
  std::string items;
  for (const Reference& r : references(markdown)) {
    items += element("dt", "[" + escaped(r.key) + "]", {{"id", "ref-" + r.key}}) + block("dd", inline_markdown(r.text));
  }
  return items.empty() ? "" : block("dl", "\n" + items, {{"class", "references"}});
}

Section references_section() { return {"references", "References", references_list(embedded::references_md)}; }

std::string cited_prose(std::string_view text) {
  std::string html = prose(text);
  for (const Reference& r : known()) {
    const std::string link = "[" + element("a", escaped(r.key), {{"href", "#ref-" + r.key}});
    const std::string plain = "[" + r.key;
    std::size_t at = 0;
    while ((at = html.find(plain, at)) != std::string::npos) {
      const char next = at + plain.size() < html.size() ? html[at + plain.size()] : ' ';
      const bool cited = next == ',' || next == ']';
      if (cited) html.replace(at, plain.size(), link);
      at += cited ? link.size() : plain.size();
    }
  }
  return html;
}

}  // namespace steadyslide::app
