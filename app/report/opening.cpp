// The beginning of the page: the paper, the problem and the main result, the counts, and how the page was made.

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "app/embedded.hpp"
#include "app/html/mathml.hpp"
#include "app/report/sections.hpp"
#include "proofs_checks/statements/paper_statements.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;

using Counts = std::vector<std::pair<std::string_view, std::size_t>>;

/// Returns a row of tiles, one for each verdict, with `what` as the name of the counted things.
std::string tiles(std::string_view what, std::string_view href, const Counts& counts) {
  std::string html = span("counted", what);
  for (const auto& [verdict, n] : counts) {
    html += element("a", element("b", std::to_string(n)) + " " + element("span", verdict),
                    {{"href", href}, {"class", fmt::format("tile {}", verdict.substr(0, verdict.find(',')))}});
  }
  return block("div", html, {{"class", "tiles"}, {"id", fmt::format("tiles-{}", href.substr(1))}});
}

std::string summary(const VerifyResult& result) {
  const auto beyond = std::ranges::count_if(result.reports, &checks::Report::beyond_calculation);
  std::string text = fmt::format("{}; {}.", counts_line(result.reports), controls_line(result));
  if (beyond > 0) text += fmt::format(" Undecided because beyond calculation: {}.", beyond);
  return block("p", text, {{"id", "summary"}});
}

}  // namespace

std::string front_html(const VerifyResult& result, const Supplement& supplement) {
  std::string made =
      block("dt", "digits") +
      block("dd", fmt::format("{}, seed {}{}", static_cast<int>(result.context.digits), result.context.seed,
                              result.context.quick ? ", quick: fewer parameters" : ""));
  for (const auto& [name, value] : supplement.made) made += block("dt", escaped(name)) + block("dd", escaped(value));
  std::string html = block("p", "On " + reference_html("Bal16"), {{"class", "paper"}});
  const std::string sketch(embedded::sketch_svg);
  html += block(
      "figure",
      block("div", inline_svg(slim_svg(sketch), "sketch", "The problem"), {{"class", "drawing"}}) +
          block("figcaption", fmt::format("<strong>{}</strong> ", figure_mark) + cited_prose(embedded::result_txt)),
      {{"id", "sketch"}});
  const Counts statements = checks::statement_counts(result.reports);
  if (std::ranges::any_of(statements, [](const auto& count) { return count.second > 0; }))
    html += tiles("statements of the paper", "#paper", statements);
  html += tiles("entries of the ledger", "#ledger", count(result.reports)) + summary(result);
  if (!result.notes.empty()) html += block("p", link(faults_line(result.notes), "notes"));
  return html + block("dl", "\n" + made, {{"class", "made"}});
}

std::vector<std::pair<std::string, std::string>> made_now() {
  std::vector<std::pair<std::string, std::string>> made{
      {"date", fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)))},
      {"program", fmt::format("steadyslide {}", version)}};
  if (!commit().empty()) made.emplace_back("commit", commit());
  made.emplace_back("compiler", compiler());
  made.emplace_back("libraries", libraries());
  return made;
}

}  // namespace steadyslide::app
