#include "app/gnuplot/gnuplot.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <boost/algorithm/string/replace.hpp>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "app/terminal/failure.hpp"
#include "app/terminal/memory_file.hpp"
#include "symbolic/field/plain_formula.hpp"

namespace steadyslide::app {
namespace {

[[noreturn]] void fail(const std::string& what) { throw Failure(ExitCode::failed, "gnuplot: " + what); }

/// gnuplot shows the wrong line first, then the reason.
std::string last_line(std::string text) {
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  if (text.empty()) return "no message";
  const std::size_t begin = text.find_first_not_of(' ', text.rfind('\n') + 1);
  return text.substr(begin);
}

/// Returns the text after the last ": ", or the whole text if there is none.
std::string after_last_colon(const std::string& text) {
  const std::size_t colon = text.rfind(": ");
  return colon == std::string::npos ? text : text.substr(colon + 2);
}

}  // namespace

std::string run_gnuplot(const std::string& script) try {
  const MemoryFile out, err;
  // If this process has been interrupted meanwhile, its files are gone. The shell must not say so on the terminal.
  const std::string command = fmt::format(
      "exec 2> /dev/null; exec 2> {}; exec /usr/bin/env -u GNUTERM LC_ALL=C.UTF-8 gnuplot --default-settings - > {}",
      err.path(), out.path());
  std::FILE* const in = ::popen(command.c_str(), "w");
  if (in == nullptr) fail(std::string("cannot be run: ") + std::strerror(errno));
  // If gnuplot ends early, SIGPIPE must not end this process.
  const auto on_broken_pipe = std::signal(SIGPIPE, SIG_IGN);
  const std::size_t written = std::fwrite(script.data(), 1, script.size(), in);
  const int status = ::pclose(in);
  std::signal(SIGPIPE, on_broken_pipe);
  const std::string complaint = last_line(err.text());
  // env exits with 127 if it does not find gnuplot, and with 126 if it cannot run it.
  switch (WIFEXITED(status) ? WEXITSTATUS(status) : -1) {
    case 0:
      if (written < script.size()) fail("did not read the whole script");
      return out.text();
    case 127: fail("not found; figures are drawn by gnuplot 5.4 or later (Debian's package gnuplot-nox)");
    case 126: fail("cannot be run: " + after_last_colon(complaint));
    default: fail("did not draw the figure: " + complaint);
  }
} catch (const std::system_error& error) {
  fail(error.what());
}

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
