#include "app/solve_command.hpp"

#include <fmt/format.h>

#include "app/list_parser.hpp"
#include "app/solve_writers.hpp"
#include "app/solver.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t max_places = 100000;
constexpr int csv_samples = 101;

Failure inapplicable(const Problem& problem, Method method, const std::string& why_not) {
  if (method == Method::closed_form) {
    return bad_command_line("--method closed-form: no closed form applies; " + why_not);
  }
  return {ExitCode::bad_input, problem.file + ": " + why_not};
}

ExitCode solve_once(const SolveOptions& options, const Problem& problem) {
  Solver::Wanted wanted{options.method, options.common.digits, {}, options.samples};
  if (!options.at.empty()) wanted.at = parse_list("--at", options.at, max_places);
  const Format format = options.common.format;
  if (format == Format::csv && wanted.at.empty() && wanted.samples == 0) wanted.samples = csv_samples;

  Output output(options.common.output);
  const SolveReport report = Solver(std::move(wanted)).solve(problem);
  if (!report.why_not.empty()) throw inapplicable(problem, options.method, report.why_not);
  switch (format) {
    case Format::json: write_solve_json(problem, report, output); break;
    case Format::csv: write_solve_csv(report, output); break;
    default: write_solve_text(problem, report, output); break;
  }
  output.commit();
  if (report.is_solved()) return ExitCode::done;
  throw Failure(ExitCode::refuted, fmt::format("{}: the solve did not converge: {}; what was reached is printed",
                                               problem.file, report.shortcoming));
}

}  // namespace

ExitCode run(const SolveOptions& options) {
  const Problem problem = read_problem(options.problem);
  return solve_once(options, problem);
}

}  // namespace steadyslide::app
