// The page's list of references, made of docs/references.md, and links from citations to this list.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <regex>
#include <vector>

#include "app/embedded.hpp"
#include "app/html/mathml.hpp"
#include "app/report/sections.hpp"
#include "proofs_checks/proof/markdown.hpp"

namespace steadyslide::app {
namespace {

struct Reference {
  std::string key;
  std::string text;                                 ///< Markdown
  std::vector<std::vector<std::string>> rows = {};  ///< the rows of the table after the text, the first two its head
};

std::vector<Reference> references(std::string_view markdown) {
  std::vector<Reference> found;
  bool inside = false;
  for (const std::string_view line : proofs_checks::parts_of(markdown, "\n")) {
    const std::size_t close = line.find("]**");
    if (line.starts_with("**[") && close != std::string_view::npos) {
      found.push_back({std::string(line.substr(3, close - 3)), std::string(line.substr(close + 3))});
      inside = true;
    } else if (line.starts_with("|") && !found.empty()) {
      found.back().rows.push_back(cells_of_row(line));
      inside = false;
    } else if (line.empty() || !inside) {
      inside = false;
    } else {
      found.back().text += " " + std::string(line);
    }
  }
  return found;
}

/// Returns Markdown as HTML. It knows emphasis and links alone.
std::string inline_markdown(std::string_view text) {
  static const std::regex link(R"(\[([^\]]*)\]\(([^)]*)\))");
  static const std::regex emphasis(R"(\*([^*]*)\*)");
  const std::string linked = std::regex_replace(escaped(text), link, R"(<a href="$2">$1</a>)");
  return std::regex_replace(linked, emphasis, "<em>$1</em>");
}

/// Matches "[Key" if a comma or a closing bracket follows, for the keys of the list.
std::regex citation() {
  std::vector<std::string> keys;
  for (const Reference& r : references(embedded::references_md)) keys.push_back(r.key);
  return std::regex(fmt::format(R"(\[({})(?=[,\]]))", fmt::join(keys, "|")));
}

/// Returns a reference as HTML. Its table is folded behind the last sentence of the text, "The places cited here:".
std::string reference_text(const Reference& reference) {
  if (reference.rows.size() < 3) return inline_markdown(reference.text);
  const std::size_t sentence = reference.text.rfind(". ") + 2;
  const std::vector<std::string>& columns = reference.rows.front();
  HtmlRows rows;
  for (std::size_t k = 2; k < reference.rows.size(); ++k) {
    for (std::vector<std::string>& row = rows.emplace_back(); const std::string& cell : reference.rows[k])
      row.push_back(lined(cell));
    rows.back().resize(columns.size());
  }
  const std::string line = reference.text.substr(sentence, reference.text.find_last_not_of(": ") + 1 - sentence);
  return inline_markdown(reference.text.substr(0, sentence)) +
         folded(escaped(line), table_element(line, columns, rows));
}

}  // namespace

std::string references_list(std::string_view markdown) {
  std::string items;
  for (const Reference& r : references(markdown)) {
    items += element("dt", "[" + escaped(r.key) + "]", {{"id", "ref-" + r.key}}) + block("dd", reference_text(r));
  }
  return items.empty() ? "" : block("dl", "\n" + items, {{"class", "references"}});
}

std::string reference_html(std::string_view key) {
  const std::vector<Reference> all = references(embedded::references_md);
  const auto found = std::ranges::find(all, key, &Reference::key);
  if (found == all.end()) return "";
  const std::size_t end = found->rows.empty() ? std::string::npos : found->text.rfind(". ") + 1;
  return inline_markdown(found->text.substr(0, end));
}

std::string cited(const std::string& html) {
  static const std::regex known = citation();
  return std::regex_replace(html, known, R"([<a href="#ref-$1">$1</a>)");
}

std::string cited_prose(std::string_view text) { return cited(prose(text)); }

}  // namespace steadyslide::app
