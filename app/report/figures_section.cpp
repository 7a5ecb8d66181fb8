#include "app/report/inline_svg.hpp"
#include "app/report/references.hpp"
#include "app/report/sections.hpp"

namespace steadyslide::app {
namespace {

std::string figure(const DrawnFigure& drawn) {
  const std::string caption = element("strong", cited_prose(drawn.title)) + " " + cited_prose(drawn.caption) +
                              element("code", escaped(drawn.command), {{"class", "command"}});
  return element(
             "figure",
             "\n" +
                 element("div", inline_svg(drawn.svg, drawn.name, drawn.title),
                         {{"class", "drawing"}, {"tabindex", "0"}, {"role", "region"}, {"aria-label", drawn.title}}) +
                 "\n" + element("figcaption", caption) + "\n",
             {{"id", "figure-" + drawn.name}}) +
         "\n";
}

}  // namespace

Section figures_section(const Supplement& supplement) {
  Section section{"figures", "Figures", ""};
  if (!supplement.no_figures.empty()) section.html += element("p", escaped(supplement.no_figures)) + "\n";
  for (const DrawnFigure& drawn : supplement.figures) section.html += figure(drawn);
  return section;
}

}  // namespace steadyslide::app
