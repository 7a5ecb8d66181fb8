#include <fmt/format.h>

#include "app/results/number_rows.hpp"
#include "app/results/solve_text_lines.hpp"
#include "app/results/solve_writers.hpp"

namespace steadyslide::app {
namespace {

std::string counted(int n, const std::string& what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

std::string outcome(const SearchReport& report) {
  const int solutions = static_cast<int>(report.solutions.size());
  if (report.agreed()) return fmt::format("{}, one solution", counted(report.starts, "start"));
  std::string text = fmt::format("{}, {}", counted(report.starts, "start"), counted(solutions, "solution"));
  if (report.unsolved > 0) text += fmt::format("; {} led to none", report.unsolved);
  return text;
}

void write_found(const SolveReport& report, Output& output) {
  write_contact(report, output);
  write_line(output, "effective friction", report.effective_friction);
  write_line(output, "centre of pressure", report.centre_of_pressure);
  if (report.tilt) write_line(output, "tilt", *report.tilt);
  write_line(
      output, "residuals",
      fmt::format("equation {}, load {}, penetration {}, tension {}", shown(report.residual_equation),
                  shown(report.residual_load), shown(report.residual_penetration), shown(report.residual_tension)));
}

}  // namespace

void write_search_text(const Problem& problem, const SearchReport& report, Output& output) {
  write_problem(problem.contact, output);
  output.write(outcome(report) + "\n");
  int number = 0;
  for (const FoundReport& found : report.solutions) {
    output.write(fmt::format("\nsolution {}, met {}, on cells\n", ++number, counted(found.times, "time")));
    write_found(found.variational, output);
    output.write(found.refined ? "refined by the Riemann-Hilbert method\n"
                               : "the Riemann-Hilbert method finds no solution there\n");
    if (found.refined) write_found(*found.refined, output);
  }
  if (report.solutions.size() > 1 && report.refinements == 1) {
    output.write("\nthe refinements are one solution: more cells tell whether there are several\n");
  }
  write_uniqueness(report.uniqueness, report.shortcoming, output);
}

void write_search_csv(const SearchReport& report, Output& output) {
  NumberRows rows(Format::csv,
                  {{"solution"},
                   {"times"},
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
                   {"equation"},
                   {"load"},
                   {"penetration"},
                   {"tension"},
                   {"refined"}},
                  output);
  int number = 0;
  for (const FoundReport& found : report.solutions) {
    const SolveReport& shape = found.variational;
    ++number;
    int component = 0;
    for (const auto& [left, right] : shape.contact) {
      rows.row({std::to_string(number), std::to_string(found.times), std::to_string(++component), left.x, left.kind,
                left.intensity, right.x, right.kind, right.intensity, shape.effective_friction,
                shape.centre_of_pressure, shape.load_share, shape.tilt.value_or(NumberText{}), shape.residual_equation,
                shape.residual_load, shape.residual_penetration, shape.residual_tension, found.refined ? "yes" : "no"});
    }
  }
  rows.end();
}

}  // namespace steadyslide::app
