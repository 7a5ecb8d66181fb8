#include "app/report/sections.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <sstream>

#include "app/embedded.hpp"
#include "app/html/mathml.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;

std::string code(std::string_view text) { return element("code", escaped(text)); }

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

/// gnuplot's SVG without what nothing is drawn by: empty groups and texts, defaults, the blanks between elements.
std::string slim_svg(std::string svg) {
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

std::string drawing(const DrawnFigure& drawn) {
  const std::string caption = element("strong", std::string(figure_mark) + " " + cited_prose(drawn.title)) + " " +
                              cited_prose(drawn.caption) +
                              element("code", escaped(drawn.command), {{"class", "command"}});
  return block("figure",
               "\n" +
                   block("div", inline_svg(slim_svg(drawn.svg), drawn.name, drawn.title),
                         {{"class", "drawing"}, {"tabindex", "0"}, {"role", "region"}, {"aria-label", drawn.title}}) +
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
    head.push_back(worded(table.columns[k]));
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
