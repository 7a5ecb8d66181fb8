#include <boost/algorithm/string/replace.hpp>

#include "app/gnuplot/gnuplot.hpp"
#include "symbolic/field/plain_formula.hpp"

namespace steadyslide::app {
namespace {

std::string svg_escaped(std::string_view marked) {
  std::string text = symbolic::without_marks(marked);
  for (const auto& [sign, name] : {std::pair("&", "&amp;"), {"<", "&lt;"}, {">", "&gt;"}}) {
    boost::replace_all(text, sign, name);
  }
  return text;
}

/// Replaces the text of the first element `name`.
void set_element(std::string& svg, const std::string& name, const std::string& text) {
  const std::size_t begin = svg.find("<" + name + ">");
  const std::size_t end = svg.find("</" + name + ">");
  if (begin == std::string::npos || end == std::string::npos) return;
  const std::size_t inside = begin + name.size() + 2;
  svg.replace(inside, end - inside, text);
}

/// Completes gnuplot's SVG for a page with several pictures: ids and references to them begin with the figure's name,
/// title and description are those of the figure, and fonts have fallbacks.
std::string finished_svg(const std::string& svg, const Figure& figure) {
  std::string result = svg;
  for (const char* before : {" id='", " id=\"", "'#", "\"#", "(#"}) {
    for (const char* id : {"gp", "textbox", "greybox", "gnuplot_canvas"}) {
      boost::replace_all(result, std::string(before) + id, before + figure.id_prefix() + "_" + id);
    }
  }
  // Blanks between upright and italic text are lost if this attribute is absent.
  boost::replace_all(result, "<svg \n", "<svg xml:space=\"preserve\"\n");
  set_element(result, "title", svg_escaped(figure.title));
  set_element(result, "desc", svg_escaped(figure.caption + " Made by: " + figure.command()));
  boost::replace_all(result, "font-family=\"Helvetica\"",
                     "font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\"");
  return result;
}

}  // namespace

std::string Figure::id_prefix() const { return boost::replace_all_copy(name, "-", "_"); }

std::string rendered_picture(const Figure& figure, Picture picture) {
  const std::string bytes = run_gnuplot(gnuplot_script(figure, picture));
  return picture == Picture::svg ? finished_svg(bytes, figure) : bytes;
}

}  // namespace steadyslide::app
