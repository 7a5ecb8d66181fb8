#include "app/figures/svg.hpp"

#include <string_view>

#include "app/figures/gnuplot_script.hpp"

namespace steadyslide::app {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '`') continue;
    result += c == '&' ? std::string("&amp;") : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  return result;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
}

/// The first element `name`, with this text in it.
void set_element(std::string& svg, const std::string& name, const std::string& text) {
  const std::size_t begin = svg.find("<" + name + ">");
  const std::size_t end = svg.find("</" + name + ">");
  if (begin == std::string::npos || end == std::string::npos) return;
  const std::size_t inside = begin + name.size() + 2;
  svg.replace(inside, end - inside, text);
}

}  // namespace

std::string finished_svg(const std::string& svg, const Figure& figure) {
  std::string result = svg;
  for (const char* before : {" id='", " id=\"", "'#", "\"#", "(#"}) {
    for (const char* id : {"gp", "textbox", "greybox", "gnuplot_canvas"}) {
      replace_all(result, std::string(before) + id, before + id_prefix(figure) + "_" + id);
    }
  }
  // Without it, blanks between upright and italic text are lost.
  replace_all(result, "<svg \n", "<svg xml:space=\"preserve\"\n");
  set_element(result, "title", escaped(figure.title));
  set_element(result, "desc", escaped(figure.caption + " Made by: " + command_of(figure)));
  replace_all(result, "font-family=\"Helvetica\"", "font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\"");
  return result;
}

}  // namespace steadyslide::app
