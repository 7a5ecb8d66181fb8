// `steadyslide figures`: its files, and its messages when it fails.

#include <csignal>

#include "app/command_line.hpp"
#include "app/made_figures.hpp"
#include "app/svg.hpp"

using namespace steadyslide::app;

namespace {

/// Returns enhanced text as it is displayed: "{/:Italic t}_n" becomes "tn".
std::string plain(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 9, "{/:Italic") == 0) i += 10;
    if (std::string("{}_^").find(text[i]) == std::string::npos) result += text[i];
  }
  return result;
}

void check_texts(const Figure& figure, const std::string& svg) {
  const std::string shown = shown_text(svg);
  CHECK(holds(shown, figure.title + "\n"));
  CHECK(holds(shown, "steadyslide figures --figure " + figure.name + "\n"));
  for (const Panel& panel : figure.panels) {
    for (const Axis* axis : {&panel.x, &panel.y}) CHECK_MESSAGE(holds(shown, plain(axis->label)), axis->label);
    if (panel.map) CHECK(holds(shown, plain(panel.map->label)));
    for (const Note& note : panel.notes) CHECK(holds(shown, plain(note.text)));
    for (const Series& series : panel.series) {
      CAPTURE(series.legend);
      CHECK((panel.legend == LegendAt::none || holds(shown, plain(series.legend))));
      CHECK_FALSE(series.points.empty());
    }
  }
  // The control: another title is not found.
  CHECK_FALSE(holds(shown, figure.title + "?"));
}

/// True if the label has a unit, or is the name of a quantity without one: cells, nodes, friction, relative errors.
bool has_unit(const std::string& label) {
  if (label.empty() || holds(label, "/") || holds(label, "(")) return true;
  const std::vector<std::string> pure = lines(
      "cells N\nnodes n of a rule\nrelative error of an equation\nfriction of the right coating f\n"
      "friction on the left f−\nfriction on the right f+\n");
  return std::ranges::count(pure, plain(label)) > 0;
}

Finished with_path(const std::string& path, const std::filesystem::path& folder) {
  return run_program_by({"env", "PATH=" + path}, {"figures", "-o", "out"}, folder);
}

}  // namespace

TEST_CASE("every figure is complete, the same each time, and shows title, axes with units, legend and command") {
  const TemporaryFolder folder;
  CHECK(out_of(folder.run({"figures", "-o", "new/folder"})) == "");
  REQUIRE(figures().size() == 17);
  std::set<std::string> all_ids;
  std::vector<std::string> files;
  for (const FigureMaker& maker : figures()) {
    const Figure& figure = made(maker.name);
    const DrawnFigure drawn = draw(figure);
    CAPTURE(drawn.name);
    for (const Panel& panel : figure.panels) {
      CHECK(has_unit(panel.x.label));
      CHECK(has_unit(panel.y.label));
    }
    check_texts(figure, drawn.picture);
    const std::string svg = folder.read("new/folder/" + drawn.name + ".svg");
    CHECK((svg == drawn.picture));
    CHECK(drawn.name == maker.name);
    CHECK(drawn.command == "steadyslide figures --figure " + drawn.name);
    CHECK(std::ranges::count(drawn.caption, '`') % 2 == 0);
    CHECK(svg.rfind("<?xml", 0) == 0);
    CHECK(is_well_formed(svg));
    CHECK_FALSE(is_well_formed(svg.substr(0, svg.size() / 2)));
    CHECK(holds(svg, "<title>" + drawn.title + "</title>"));
    CHECK(holds(svg, "fill=\"#ffffff\""));
    CHECK_FALSE(holds(svg, "<script"));
    CHECK_FALSE(holds(svg, "onclick"));
    for (const char* number : {" nan", ",nan", "inf,", ",inf"}) CHECK_FALSE(holds(svg, number));
    for (std::size_t at = 0; (at = svg.find(" id=", at)) != std::string::npos; ++at) {
      const std::string id = svg.substr(at + 5, svg.find(svg[at + 4], at + 5) - at - 5);
      CAPTURE(id);
      CHECK(all_ids.insert(id).second);
    }
    // References use ids of the same figure.
    for (std::size_t at = 0; (at = svg.find("xlink:href='#", at)) != std::string::npos; ++at) {
      const std::size_t begin = at + 13;
      const std::string id = svg.substr(begin, svg.find('\'', begin) - begin);
      if (!all_ids.contains(id)) FAIL_CHECK(id);
    }
    files.push_back(drawn.name + ".svg");
  }
  std::ranges::sort(files);
  CHECK(folder.names("new/folder") == files);
  CHECK_FALSE(has_unit("pressure"));
}

TEST_CASE("patterns select figures") {
  const TemporaryFolder folder;
  CHECK(folder.run({"figures", "--figure", "friction-jump-*", "--figure", "parabol?"}).code == 0);
  CHECK(folder.names() == words("friction-jump-falling.svg friction-jump-rising.svg parabola.svg"));

  const Finished help = run_alone({"figures", "--help"});
  for (const FigureMaker& maker : figures()) CHECK(holds(help.out, "  " + maker.name + "\n"));
}

TEST_CASE("figures are the same to the byte for every number of jobs") {
  const TemporaryFolder folder;
  const auto drawn_by = [&](const std::string& jobs) {
    const auto out = folder.path() / jobs;
    CHECK(out_of(run_program({"figures", "--figure", "*a*", "--jobs", jobs, "-o", out, "--data", out}, ".")) == "");
    std::map<std::string, std::string> files;
    for (const std::string& name : folder.names(jobs)) files[name] = folder.read(jobs + "/" + name);
    return files;
  };
  const auto one = drawn_by("1");
  CHECK(one.size() > 10);
  CHECK((drawn_by("2") == one));
  CHECK((drawn_by("50") == one));
}

TEST_CASE("without gnuplot there is one line of error and no file") {
  const TemporaryFolder folder;
  check_refused(with_path("", folder.path()),
                "gnuplot: not found; figures are drawn by gnuplot 5.4 or later (Debian's package gnuplot-nox)", 3);
  CHECK(folder.names().empty());

  // gnuplot fails here.
  folder.write("gnuplot", "#!/bin/sh\necho 'line 1: out of order' >&2\nexit 1\n");
  std::filesystem::permissions(folder.path() / "gnuplot", std::filesystem::perms::owner_all);
  check_refused(with_path(folder.path().string(), folder.path()),
                "gnuplot: did not draw the figure: line 1: out of order", 3);
  CHECK(folder.names() == std::vector<std::string>{"gnuplot"});
}

TEST_CASE("a figure that cannot be written leaves no file") {
  const TemporaryFolder folder{{"file", "kept"}};
  const auto draws_into = [&](const std::string& name) {
    return folder.run({"figures", "-o", name, "--figure", "parabola"});
  };
  check_refused(draws_into("file"), "file: is no folder", 3);
  check_refused(draws_into("file/new"), "file/new: cannot be made: Not a directory", 3);
  CHECK(folder.read("file") == "kept");
  // A folder has the name of the figure's file.
  std::filesystem::create_directory(folder.path() / "parabola.svg");
  check_refused(draws_into("."), "./parabola.svg: cannot be written: Is a directory", 3);
  CHECK(folder.names() == std::vector<std::string>{"file", "parabola.svg"});
}

TEST_CASE("interrupted, figures leaves no files and a clean terminal") {
  const TemporaryFolder folder;
  const Finished finished = interrupt_on_terminal({"figures", "-o", "out"}, folder.path(), "[", SIGINT);
  CHECK(finished.code == 130);
  CHECK(folder.names().empty());
  CAPTURE(finished.err);
  CHECK(finished.err.ends_with("\r\x1b[K"));
}
