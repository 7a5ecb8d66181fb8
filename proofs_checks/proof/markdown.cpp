#include "proofs_checks/proof/markdown.hpp"

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <stdexcept>

namespace steadyslide::proofs_checks {

std::string_view section_of(std::string_view page, std::string_view heading) {
  const std::string line = "\n" + std::string(heading) + "\n";
  const std::size_t at = page.find(line);
  if (at == std::string_view::npos) throw std::logic_error("no section " + std::string(heading));
  page.remove_prefix(at + line.size());
  for (std::size_t level = heading.find(' '); level > 0; --level) {
    page = page.substr(0, page.find("\n" + std::string(level, '#') + " "));
  }
  return page;
}

std::vector<std::string> cells_of(std::string_view row) {
  std::vector<std::string> cells;
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (row[k] == '|') {
      cells.emplace_back();
    } else if (!cells.empty()) {
      if (row.substr(k, 2) == "\\|") ++k;
      cells.back() += row[k];
    }
  }
  if (!cells.empty()) cells.pop_back();  // the text after the last bar
  for (std::string& cell : cells) boost::algorithm::trim(cell);
  return cells;
}

bool is_rule_of_table(std::string_view row) {
  return row.starts_with("|-") || row.starts_with("|:") || row.starts_with("| -");
}

std::vector<std::string_view> parts_of(std::string_view text, std::string_view separator) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0; !text.empty() && from <= text.size();) {
    parts.push_back(text.substr(from, text.find(separator, from) - from));
    from += parts.back().size() + separator.size();
  }
  return parts;
}

std::vector<std::string> list_of(std::string_view text, std::string_view separator) {
  const std::vector<std::string_view> parts = parts_of(text, separator);
  return {parts.begin(), parts.end()};
}

std::vector<std::string> items_of(std::string_view text) {
  std::vector<std::string> items(1);
  int depth = 0;  // depth of round brackets and braces
  bool quoted = false;
  bool interval = false;  // between the two square brackets of an interval
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '`') continue;
    if (c == '"') quoted = !quoted;
    if (!quoted) {
      if (c == '(' || c == '{') ++depth;
      if (c == ')' || c == '}') --depth;
      if (c == '[' || c == ']') interval = !interval;
    }
    if (c == ',' && depth == 0 && !quoted && !interval) {
      items.emplace_back();
    } else {
      items.back() += c;
    }
  }
  for (std::string& item : items) boost::algorithm::trim(item);
  if (items.back().ends_with('.')) items.back().pop_back();
  std::erase(items, "");
  return items;
}

}  // namespace steadyslide::proofs_checks
