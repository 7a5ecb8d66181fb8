#include "app/report/sections.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/replace.hpp>

#include "app/embedded.hpp"
#include "app/report/mathml.hpp"
#include "proofs_checks/statements/paper_statements.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;

std::string code(std::string_view text) { return element("code", escaped(text)); }

std::vector<std::string> typeset(const std::vector<std::string>& cells) {
  std::vector<std::string> html;
  for (const std::string& cell : cells) html.push_back(cited_prose(cell));
  return html;
}

std::string drawing(const DrawnFigure& drawn) {
  const std::string caption = element("strong", cited_prose(drawn.title)) + " " + cited_prose(drawn.caption) +
                              element("code", escaped(drawn.command), {{"class", "command"}});
  return block("figure",
               "\n" +
                   block("div", inline_svg(drawn.svg, drawn.name, drawn.title),
                         {{"class", "drawing"}, {"tabindex", "0"}, {"role", "region"}, {"aria-label", drawn.title}}) +
                   block("figcaption", caption),
               {{"id", "figure-" + drawn.name}});
}

std::string table_html(const TextTable& table) {
  HtmlRows rows;
  for (const std::vector<std::string>& row : table.rows) rows.push_back(typeset(row));
  std::string html = block("h3", cited_prose(table.title));
  if (!table.note.empty()) html += block("p", cited_prose(table.note));
  html += table_element(table.title, typeset(table.columns), rows);
  std::string sources;
  for (const std::string& reference : table.references) sources += block("li", cited_prose(reference));
  return sources.empty() ? html : html + block("ul", "\n" + sources, {{"class", "sources"}});
}

/// A path, which may go on in the next line after a part of it.
std::string path(std::string_view file) {
  std::string html;
  for (const char c : file) {
    html += escaped({&c, 1});
    if (c == '/' || c == '_') html += "<wbr>";
  }
  return element("code", html);
}

/// Takes one line off the front.
std::vector<std::string> take_line(std::string_view& csv) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  while (!csv.empty()) {
    const char c = csv.front();
    csv.remove_prefix(1);
    if (quoted && c == '"' && csv.starts_with('"')) {
      fields.back() += '"';
      csv.remove_prefix(1);
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      fields.emplace_back();
    } else if (!quoted && c == '\n') {
      break;
    } else if (c != '\r') {
      fields.back() += c;
    }
  }
  return fields;
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

}  // namespace

std::vector<Mutant> read_mutants(std::string_view csv) {
  std::vector<Mutant> mutants;
  take_line(csv);
  while (!csv.empty()) {
    std::vector<std::string> fields = take_line(csv);
    if (fields.size() == 1 && fields.front().empty()) continue;
    fields.resize(5);
    mutants.push_back({fields[0], fields[1], fields[2], fields[3], fields[4]});
  }
  return mutants;
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

std::string options_again(const checks::Context& context) {
  return fmt::format(" --digits {} --seed {}{}", static_cast<int>(context.digits), context.seed,
                     context.quick ? " --quick" : "");
}

std::string paper_html(const VerifyResult& result) {
  HtmlRows rows;
  for (const checks::PaperStatement& statement : checks::paper_statements()) {
    const auto links_to = [&](const std::vector<std::string_view>& ids) {
      std::string links;
      for (const std::string_view id : ids) {
        const checks::Report* report = report_on(id, result.reports);
        if (report == nullptr) continue;
        const std::string link = element("a", escaped(id), {{"href", "#" + report->claim.id}});
        links += element("span", link + " " + badge(report->verdict), {{"class", "verdict-link"}}) + " ";
      }
      return links;
    };
    const std::string said = links_to(statement.claims);
    const std::string instances = links_to(statement.instances);
    if (said.empty() && instances.empty()) continue;
    const auto verdict = checks::verdict_of(statement, result.reports);
    const std::string place = statement.place.empty() ? "<em>beyond the paper</em>" : escaped(statement.place);
    rows.push_back({place, prose(statement.what), verdict ? badge(*verdict) : "", said, instances});
  }
  if (rows.empty()) return "";
  return block("p",
               "What the paper says, in its order, and the entries of the ledger that say it, in the scope that their "
               "words give: a statement is as good as the weakest of them. Others examine instances of it.") +
         table_element("The paper, statement by statement", {"place", "statement", "verdict", "said by", "instances"},
                       rows);
}

std::string notes_html(const VerifyResult& result) {
  if (result.notes.empty() && result.notes_left_out == 0) return "";
  std::string html = block("p",
                           "Places where the text of the paper at hand and the mathematics disagree. That text was "
                           "extracted from a PDF: each note says whether that may have made the difference, or whether "
                           "it is more likely <em>the print's</em>, a slip in the paper itself.");
  if (result.notes_left_out > 0) {
    html += block("p", fmt::format("Left out are {} notes on statements that were not examined in this run.",
                                   result.notes_left_out));
  }
  HtmlRows rows;
  for (const checks::ReadingNote& note : result.notes) {
    std::string place =
        element("code", escaped(note.id), {{"id", "note-" + note.id}}) + "<br>" + cited_prose(note.place);
    if (!note.claim.empty()) place += "<br>" + element("a", "the statement", {{"href", "#" + note.claim}});
    rows.push_back({place, cited_prose(note.printed), cited_prose(note.derived), cited_prose(note.evidence)});
  }
  if (rows.empty()) return html;
  return html +
         table_element("Reading notes", {"place", "printed", "derived", "evidence, and the likely origin"}, rows);
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
         table_element("Faults put into the program", {"id", "file", "change", "noticed by", "evidence"}, rows);
}

std::string reproduce_html(const VerifyResult& result) {
  const std::string options = options_again(result.context);
  const std::string commands = "steadyslide report -o DIR" + options + "\nsteadyslide verify --claim ID" + options +
                               "\nsteadyslide verify --list\n";
  return block("p",
               "The page again, one statement alone, and the list of all statements. Random parameters follow from the "
               "seed, so that only the seconds differ:") +
         block("pre", code(commands), {{"tabindex", "0"}}) +
         block("p", fmt::format("To cite it: <em>steadyslide</em>, version {}, together with the paper whose theory it "
                                "examines, [<a href=\"#ref-Bal16\">Bal16</a>].",
                                version));
}

}  // namespace steadyslide::app
