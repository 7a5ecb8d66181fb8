#include "app/results/row_writer.hpp"
#include "app/results/solve_writers.hpp"

namespace steadyslide::app {

void write_load_steps(Format format, const std::vector<LoadStep>& steps, Output& output) {
  std::vector<Column> columns{{"load"},
                              {"component"},
                              {"left"},
                              {"left_kind"},
                              {"left_intensity"},
                              {"right"},
                              {"right_kind"},
                              {"right_intensity"},
                              {"effective_friction"},
                              {"centre_of_pressure"},
                              {"load_share"},
                              {"tilt"},
                              {"shortcoming"}};
  const auto rows = make_row_writer(format, std::move(columns), output);
  const auto write = [&](std::vector<Cell> cells) {
    // In a text a column that is sometimes empty could not be told from its neighbour.
    for (Cell& cell : cells) {
      if (format == Format::text && (cell == Cell("") || cell == Cell(std::vector<std::string>()))) cell = "-";
    }
    rows->row(cells);
  };
  for (const auto& [load, report] : steps) {
    const std::string& shortcoming = report.why_not.empty() ? report.shortcoming : report.why_not;
    const std::string tilt = report.tilt.value_or("");
    int component = 0;
    for (const auto& [left, right] : report.contact) {
      write({load, std::to_string(++component), left.x, left.kind, left.intensity, right.x, right.kind, right.intensity,
             report.effective_friction, report.centre_of_pressure, report.load_share, tilt, shortcoming});
    }
    if (component == 0) write({load, "", "", "", "", "", "", "", "", "", std::vector<std::string>(), "", shortcoming});
  }
  rows->end();
}

}  // namespace steadyslide::app
