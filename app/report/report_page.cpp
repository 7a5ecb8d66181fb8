#include "app/report/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/embedded.hpp"
#include "app/report/sections.hpp"

namespace steadyslide::app {
namespace {

std::string tile(std::string_view verdict, std::size_t n) {
  return element("a", element("b", std::to_string(n)) + " " + element("span", verdict),
                 {{"href", "#ledger"}, {"class", "tile " + std::string(verdict)}});
}

std::string tiles(const VerifyResult& result) {
  const proofs_checks::Counts counts = count(result.reports);
  return tile("proved", counts.proved) + tile("supported", counts.supported) + tile("undecided", counts.undecided) +
         tile("refuted", counts.refuted);
}

std::string head(const VerifyResult& result) {
  const auto beyond = static_cast<std::size_t>(
      std::ranges::count_if(result.reports, [](const auto& report) { return report.beyond_calculation(); }));
  const std::string subtitle =
      "Steady sliding frictional contact on an elastic half-plane with a discontinuous friction coefficient: the "
      "statements of the theory, examined one by one";
  std::string facts = fmt::format("{}; {}.", counts_line(result), controls_line(result));
  if (beyond > 0) facts += fmt::format(" Undecided because beyond calculation: {}.", beyond);
  const std::string run =
      fmt::format("steadyslide {} · {} digits · seed {}{}", version, static_cast<int>(result.context.digits),
                  result.context.seed, result.context.quick ? " · quick: fewer parameters" : "");
  return block("header", "\n" + block("h1", "Verification report") + block("p", subtitle, {{"class", "subtitle"}}) +
                             block("p", run, {{"class", "run"}}) + block("div", tiles(result), {{"class", "tiles"}}) +
                             block("p", facts, {{"id", "summary"}}));
}

std::string contents(const std::vector<Section>& sections) {
  std::string items;
  for (const Section& s : sections) items += element("li", element("a", s.title, {{"href", "#" + s.id}}));
  return block("nav", element("ol", items), {{"aria-label", "Contents"}});
}

std::string section_html(const Section& s) {
  const std::string heading = s.id + "-heading";
  return block("section", "\n" + block("h2", s.title, {{"id", heading}}) + s.html,
               {{"id", s.id}, {"aria-labelledby", heading}});
}

}  // namespace

std::string report_html(const VerifyResult& result, const Supplement& supplement) {
  std::vector<Section> sections{guide_section(),
                                paper_section(result),
                                ledger_section(result),
                                notes_section(result),
                                figures_section(supplement),
                                tables_section(supplement.tables),
                                mutants_section(supplement.mutants),
                                reproduce_section(result),
                                references_section()};
  std::erase_if(sections, [](const Section& s) { return s.html.empty(); });
  std::string body;
  for (const Section& s : sections) body += section_html(s);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en-GB\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"generator\" content=\"steadyslide {}\">\n<link rel=\"icon\" href=\"data:,\">\n"
      "<title>Verification report – steadyslide</title>\n<style>\n{}{}</style>\n</head>\n<body>\n{}{}"
      "<main>\n{}</main>\n<script>\n{}</script>\n</body>\n</html>\n",
      version, embedded::report_css, embedded::report_print_css, head(result), contents(sections), body,
      embedded::report_js);
}

}  // namespace steadyslide::app
