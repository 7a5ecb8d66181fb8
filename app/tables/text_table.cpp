#include "app/tables/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cctype>
#include <regex>

#include "app/embedded.hpp"
#include "app/results/rows.hpp"
#include "proofs_checks/proof/markdown.hpp"
#include "symbolic/field/plain_formula.hpp"

namespace steadyslide::app {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// True for "-0.25" and "1e-06"; false for words and formulas.
bool is_number(const std::string& text) {
  return std::any_of(text.begin(), text.end(), is_digit) &&
         text.find_first_not_of("0123456789+-.e") == std::string::npos;
}

/// Converts the formulas of these tables: names, with a sign or a digit as subscript, and operators.
std::string latex_formula(const std::string& formula) {
  static const std::regex command("(alpha|beta|gamma|nu|mu|kappa|arctan|pi)(?![A-Za-z])");
  static const std::regex subscript("_(.)");
  return std::regex_replace(std::regex_replace(formula, command, "\\$1 "), subscript, "_{$1}");
}

std::string latex_text(const std::string& text) {
  if (is_number(text)) return "$" + text + "$";
  std::string result;
  bool is_formula = false;
  for (const std::string& words : proofs_checks::list_of(text, "`")) {
    result += is_formula ? "$" + latex_formula(words) + "$" : latex_escaped(words);
    is_formula = !is_formula;
  }
  return result;
}

std::string markdown_row(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string latex_row(const std::vector<std::string>& cells) {
  std::vector<std::string> texts;
  for (const std::string& cell : cells) texts.push_back(latex_text(cell));
  return fmt::format("{} \\\\", fmt::join(texts, " & "));
}

/// Separates the paragraphs of a note by blank lines; in the note each is on one line.
std::string paragraphs(const std::string& note) {
  return note.empty() ? "" : boost::replace_all_copy(note, "\n", "\n\n") + "\n\n";
}

}  // namespace

std::vector<std::string> cells_of_row(std::string_view line) {
  std::vector<std::string> cells;
  for (const std::string& cell : proofs_checks::list_of(line.substr(1, line.rfind('|') - 1), "|"))
    cells.push_back(boost::trim_copy(cell));
  return cells;
}

std::string markdown_document(const std::string& title, const std::vector<TextTable>& tables) {
  std::string result = "# " + title + "\n";
  for (const TextTable& table : tables) {
    result += "\n## " + table.title + "\n\n" + paragraphs(table.note) + markdown_row(table.columns);
    result += "|";
    for (std::size_t k = 0; k < table.columns.size(); ++k) result += " --- |";
    result += "\n";
    for (const auto& row : table.rows) result += markdown_row(row);
    for (const std::string& reference : table.references) result += "\n" + reference + "\n";
  }
  return result;
}

std::string latex_document(const std::string& title, const std::vector<TextTable>& tables) {
  std::string result(embedded::preamble_tex);
  result += fmt::format("\\section*{{{}}}\n", latex_text(title));
  for (const TextTable& table : tables) {
    result += fmt::format("\n\\subsection*{{{}}}\n\n", latex_text(table.title)) + latex_text(paragraphs(table.note));
    result += fmt::format("{{\\footnotesize\n\\begin{{longtable}}{{{}}}\n", std::string(table.columns.size(), 'l'));
    result += latex_row(table.columns) + " \\hline\n\\endhead\n";
    for (const auto& row : table.rows) result += latex_row(row) + "\n";
    result += "\\end{longtable}}\n";
    for (const std::string& reference : table.references) result += "\n" + latex_text(reference) + "\n";
  }
  return result + "\\end{document}\n";
}

std::string csv_document(const std::vector<TextTable>& tables) {
  std::string result = "table,row,column,value\n";
  for (const TextTable& table : tables) {
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      for (std::size_t k = 0; k < table.columns.size(); ++k) {
        result += fmt::format("{},{},{},{}\n", csv_field(symbolic::without_marks(table.title)), i + 1,
                              csv_field(symbolic::without_marks(table.columns[k])),
                              csv_field(symbolic::without_marks(table.rows[i][k])));
      }
    }
  }
  return result;
}

}  // namespace steadyslide::app
