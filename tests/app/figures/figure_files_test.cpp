// Pictures in other formats than SVG, the tables beside them, and the copies in docs/.

#include "app/command_line.hpp"
#include "app/figures/figure_data.hpp"
#include "app/made_figures.hpp"

using namespace steadyslide::app;

TEST_CASE("tables have every number of every curve, with names and units above them") {
  for (const char* name : {"flat-punch", "parabola", "stress-map", "sketch"}) {
    const Figure& figure = made(name);
    std::vector<std::vector<std::string>> rows;
    std::string comments;
    for (const std::string& row : lines(figure_data(figure))) {
      if (row.starts_with('#')) {
        CHECK(rows.empty());
        comments += row + "\n";
        continue;
      }
      rows.push_back(cells_of(row));
      CHECK(rows.back().size() == 5);
    }
    CHECK(rows.front() == std::vector<std::string>{"panel", "curve", "x", "y", "value"});
    std::size_t at = 1;
    const auto check = [&](std::size_t panel, std::size_t curve, double x, double y) -> std::string {
      const std::vector<std::string>& row = rows.at(at++);
      if (row[0] != std::to_string(panel + 1) || row[1] != std::to_string(curve)) FAIL_CHECK(at);
      if (std::stod(row[2]) != x || std::stod(row[3]) != y) FAIL_CHECK(at);
      return row[4];
    };
    for (std::size_t k = 0; k < figure.panels.size(); ++k) {
      const Panel& panel = figure.panels[k];
      if (panel.map) {
        for (std::size_t i = 0; i < panel.map->values.size(); ++i) {
          const std::size_t width = panel.map->x.size();
          const std::string value = check(k, 0, panel.map->x[i % width], panel.map->y[i / width]);
          if (std::stod(value) != panel.map->values[i]) FAIL_CHECK(i);
        }
      }
      for (std::size_t j = 0; j < panel.series.size(); ++j) {
        for (const Point& p : panel.series[j].points) {
          if (!std::isnan(p.x)) CHECK(check(k, j + 1, p.x, p.y).empty());
        }
      }
    }
    CHECK(at == rows.size());
    CHECK(holds(comments, figure.title));
    CHECK(holds(comments, "figures --figure " + figure.name));
    if (figure.name == "flat-punch") {
      check_holds(comments, {"# panel 1: x is x / L; y is pressure −t_n  (P/L)\n",
                             "# panel 1, curve 3: line, f = 0.3\n", "# panel 1, curve 4: marks, f = 0.3\n"});
    }
    if (figure.name == "stress-map") {
      check_holds(comments, {"# panel 1, curve 0: value is von Mises stress  (P/L)\n"});
    }
  }
  CHECK(plain_text("pressure −{/:Italic t}_n") == "pressure −t_n");
}

TEST_CASE("--data writes tables, --format other pictures") {
  const TemporaryFolder folder;
  for (const auto& [format, magic] : {std::pair("pdf", "%PDF-"), {"png", "\x89PNG\r\n\x1a\n"}, {"svg", "<?xml"}}) {
    const std::string name = std::string("parabola.") + format;
    out_of(folder.run({"figures", "--figure", "parabola", "--format", format, "--data", "data", "-o", "pictures"}));
    CHECK(folder.read("pictures/" + name).starts_with(magic));
    CHECK(folder.read("pictures/" + name).size() > 10000);
    CHECK((folder.read("data/parabola.csv") == figure_data(made("parabola"))));
  }
  folder.write("file", "kept");
  check_refused(folder.run({"figures", "--figure", "parabola", "--data", "file", "-o", "new"}), "file: is no folder",
                3);
  CHECK(folder.read("file") == "kept");
  CHECK_FALSE(std::filesystem::exists(folder.path() / "new"));
}

TEST_CASE("the copies in docs/ equal the figures that the program draws") {
  for (const char* name : {"sketch", "friction-direction", "rough-surface"}) {
    const std::string copy = file_text(STEADYSLIDE_DOCS "/" + std::string(name) + ".svg");
    CHECK_MESSAGE((copy == draw(made(name)).picture), "steadyslide figures -o docs --figure ", name);
    CHECK((copy != draw(made("parabola")).picture));
  }
}
