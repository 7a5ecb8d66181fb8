#include "app/solve_command.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/list_parser.hpp"
#include "app/number_format.hpp"
#include "app/progress.hpp"
#include "app/solve_writers.hpp"
#include "app/solver.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t max_places = 100000;
constexpr std::size_t max_loads = 10000;
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

std::vector<Rational> load_list(const std::string& text) {
  std::vector<Rational> loads = parse_list("--load-steps", text, max_loads);
  for (const Rational& load : loads) {
    if (load > 0) continue;
    throw bad_command_line("--load-steps: load out of range", "the load is positive", to_string(load));
  }
  return loads;
}

Problem with_load(const Problem& problem, const Rational& load) {
  const ContactProblem& contact = problem.contact;
  return {ContactProblem(contact.elasticity(), contact.friction(), contact.indenter(), load, contact.sliding(),
                         contact.load_at()),
          problem.file, problem.samples};
}

ExitCode follow_loads(const SolveOptions& options, const Problem& problem) {
  const std::vector<Rational> loads = load_list(options.load_steps);
  Output output(options.common.output);
  Solver solver({options.method, options.common.digits, {}, 0});
  std::vector<LoadStep> steps;
  {
    Progress progress(loads.size());
    for (const Rational& load : loads) {
      steps.push_back({format_number(load, options.common.digits), solver.solve(with_load(problem, load))});
      progress.show(steps.size());
    }
  }
  const auto applies = [](const LoadStep& step) { return step.report.why_not.empty(); };
  if (std::none_of(steps.begin(), steps.end(), applies)) {
    throw inapplicable(problem, options.method, steps.front().report.why_not);
  }
  write_load_steps(options.common.format, steps, output);
  output.commit();

  const auto fails = [](const LoadStep& step) { return !step.report.is_solved(); };
  const auto first = std::find_if(steps.begin(), steps.end(), fails);
  if (first == steps.end()) return ExitCode::done;
  const SolveReport& report = first->report;
  throw Failure(ExitCode::refuted,
                fmt::format("{}: {} of {} loads not solved, first of all {}: {}; what was reached is printed",
                            problem.file, std::count_if(first, steps.end(), fails), steps.size(), first->load,
                            report.why_not.empty() ? report.shortcoming : report.why_not));
}

}  // namespace

ExitCode run(const SolveOptions& options) {
  const Problem problem = read_problem(options.problem);
  return options.load_steps.empty() ? solve_once(options, problem) : follow_loads(options, problem);
}

}  // namespace steadyslide::app
