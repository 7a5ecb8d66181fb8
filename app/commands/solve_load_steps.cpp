#include "app/results/number_rows.hpp"
#include "app/results/solve_writers.hpp"

namespace steadyslide::app {

void write_load_steps(Format format, const std::vector<LoadStep>& steps, Output& output) {
  std::vector<NumberColumn> columns{{"load"},
                                    {"component"},
                                    {"left", true},
                                    {"left_kind"},
                                    {"left_intensity", true},
                                    {"right", true},
                                    {"right_kind"},
                                    {"right_intensity", true},
                                    {"effective_friction", true},
                                    {"centre_of_pressure", true},
                                    {"load_share", true},
                                    {"tilt", true},
                                    {"shortcoming"}};
  if (format == Format::json) columns.push_back({"warnings"});
  NumberRows rows(format, columns, output);
  for (const auto& [load, report] : steps) {
    const std::string& shortcoming = report.why_not.empty() ? report.shortcoming : report.why_not;
    const NumberText none;
    const NumberText tilt = report.tilt.value_or(none);
    const auto write = [&, &noted = report.warnings](std::vector<NumberCell> cells) {
      if (format == Format::json) cells.emplace_back(noted);
      rows.row(cells);
    };
    int component = 0;
    for (const auto& [left, right] : report.contact) {
      write({load, std::to_string(++component), left.x, left.kind, left.intensity, right.x, right.kind, right.intensity,
             report.effective_friction, report.centre_of_pressure, report.load_share, tilt, shortcoming});
    }
    if (component == 0) {
      write({load, "", none, "", none, none, "", none, none, none, std::vector<NumberText>(), none, shortcoming});
    }
  }
  rows.end();
}

}  // namespace steadyslide::app
