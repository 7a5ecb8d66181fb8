#include "app/report/sections.hpp"

#include <fmt/format.h>

#include "app/embedded.hpp"
#include "app/html/mathml.hpp"
#include "app/results/rows.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;

std::string drawing(const DrawnFigure& drawn) {
  const std::string caption = element("strong", fmt::format("{} {}.", figure_mark, cited_prose(drawn.title))) + " " +
                              cited_prose(drawn.caption) +
                              element("code", escaped(drawn.command), {{"class", "command"}});
  return block("figure",
               "\n" + region("drawing", drawn.title, inline_svg(slim_svg(drawn.picture), drawn.name, drawn.title)) +
                   block("figcaption", caption),
               {{"id", "figure-" + drawn.name}});
}

std::string table_html(const TextTable& table) {
  HtmlRows columns(table.columns.size());
  for (const std::vector<std::string>& row : table.rows) {
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k].push_back(row.at(k));
  }
  HtmlRows rows(table.rows.size());
  std::vector<std::string> head;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    head.push_back(lined(table.columns[k]));
    std::vector<std::string> aligned = columns[k];
    align_numbers(aligned);
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i].push_back(aligned[i] == columns[k][i] ? cited_prose(aligned[i]) : aligned[i]);
  }
  std::string html;
  if (!table.note.empty()) html += block("p", cited_prose(table.note));
  html += table_element(table.title, head, rows, cited_prose(table.title) + ".");
  std::string sources;
  for (const std::string& reference : table.references) sources += block("li", cited_prose(reference));
  return sources.empty() ? html : html + block("ul", "\n" + sources, {{"class", "sources"}});
}

/// Returns a path as code. A line may break behind "/" and "_".
std::string path(std::string_view file) {
  std::string html;
  for (const char c : file) {
    html += escaped({&c, 1});
    if (c == '/' || c == '_') html += "<wbr>";
  }
  return element("code", html);
}

}  // namespace

std::vector<Mutant> read_mutants(std::string_view csv) {
  std::vector<Mutant> mutants;
  for (std::vector<std::string>& fields : csv_rows(csv)) {
    if (fields == std::vector<std::string>{""}) continue;
    fields.resize(5);
    mutants.push_back({fields[0], fields[1], fields[2], fields[3], fields[4]});
  }
  if (!mutants.empty()) mutants.erase(mutants.begin());  // the columns' names
  return mutants;
}

std::string options_again(const checks::Context& context) {
  return fmt::format(" --digits {} --seed {}{}", static_cast<int>(context.digits), context.seed,
                     context.quick ? " --quick" : "");
}

std::string figures_html(const Supplement& supplement) {
  std::string html;
  if (!supplement.no_figures.empty()) html += block("p", escaped(supplement.no_figures));
  for (const DrawnFigure& drawn : supplement.figures) html += drawing(drawn);
  return html;
}

std::string tables_html(const std::vector<TextTable>& tables) {
  std::string html;
  for (const TextTable& table : tables) html += table_html(table);
  return html;
}

std::string mutants_html(const std::vector<Mutant>& mutants) {
  if (mutants.empty()) return "";
  HtmlRows rows;
  for (const auto& [id, file, change, killer, evidence] : mutants) {
    rows.push_back({code(id), path(file), cited_prose(change), code(killer), cited_prose(evidence)});
  }
  return block("p", fmt::format("Controls change a statement; these changes, {} of them, were made in the program "
                                "itself, one at a time, and each was noticed by the executable named, a test or a part "
                                "of the checks, with its arguments.",
                                mutants.size())) +
         folded(fmt::format("all {} faults", mutants.size()),
                table_element("Faults put into the program", {"id", "file", "change", "noticed by", "evidence"}, rows));
}

namespace {

/// Returns how a verdict is cited, as text and as BibTeX. WHAT stands for the entry or the statement with its verdict,
/// KEY for its id.
std::string citation_html(const Supplement& supplement) {
  std::string commit, date, year;
  for (const auto& [name, value] : supplement.made) {
    if (name == "commit") commit = ", commit " + value;
    if (name == "date") date = ", " + value.substr(0, 10), year = value.substr(0, 4);
  }
  const std::string place = fmt::format("steadyslide {}{}{}", version, commit, date);
  const std::string bibtex = fmt::format(
      "@misc{{steadyslide-KEY,\n  author = {{{{The steadyslide contributors}}}},\n  title = {{WHAT}},\n"
      "  year = {{{}}},\n  note = {{{}}},\n}}\n",
      year, place);
  return block("p", escaped(place + ": WHAT.")) + block("pre", code(bibtex), {{"tabindex", "0"}});
}

}  // namespace

std::string reproduce_html(const VerifyResult& result, const Supplement& supplement) {
  const std::string options = options_again(result.context);
  const std::string commands = "steadyslide report -o DIR" + options + "\nsteadyslide verify --claim ID" + options +
                               "\nsteadyslide verify --list\n";
  return block("p",
               "The page again, one statement alone, and the list of all statements. Random parameters follow from the "
               "seed, so that only the seconds differ:") +
         block("pre", code(commands), {{"tabindex", "0"}}) +
         block(
             "p",
             cited(
                 "To cite a verdict, cite the paper, too, [Bal16]. An entry or a statement with its verdict stands for "
                 "WHAT, its id for KEY; “cite this verdict” beside it fills them in:")) +
         block("div", "\n" + citation_html(supplement), {{"id", "cite"}});
}

}  // namespace steadyslide::app
