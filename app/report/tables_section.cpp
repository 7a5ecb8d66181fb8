#include "app/report/references.hpp"
#include "app/report/sections.hpp"

namespace steadyslide::app {
namespace {

std::vector<std::string> typeset(const std::vector<std::string>& cells) {
  std::vector<std::string> html;
  html.reserve(cells.size());
  for (const std::string& cell : cells) html.push_back(cited_prose(cell));
  return html;
}

std::string one_table(const TextTable& table) {
  std::vector<std::vector<std::string>> rows;
  rows.reserve(table.rows.size());
  for (const std::vector<std::string>& row : table.rows) rows.push_back(typeset(row));
  std::string html = element("h3", cited_prose(table.title)) + "\n";
  if (!table.note.empty()) html += element("p", cited_prose(table.note)) + "\n";
  html += table_element(table.title, typeset(table.columns), rows);
  std::string sources;
  for (const std::string& reference : table.references) sources += element("li", cited_prose(reference)) + "\n";
  return sources.empty() ? html : html + element("ul", "\n" + sources, {{"class", "sources"}}) + "\n";
}

}  // namespace

Section tables_section(const std::vector<TextTable>& tables) {
  Section section{"tables", "Exponents", ""};
  for (const TextTable& table : tables) section.html += one_table(table);
  return section;
}

}  // namespace steadyslide::app
