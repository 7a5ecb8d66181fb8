#include "app/commands/solve_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "app/commands/solver.hpp"
#include "app/problem_file/list_parser.hpp"
#include "app/results/number_format.hpp"
#include "app/results/solve_writers.hpp"
#include "app/terminal/progress.hpp"

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

std::string name_of(Method method) {
  switch (method) {
    case Method::closed_form: return "closed-form";
    case Method::riemann_hilbert: return "riemann-hilbert";
    case Method::variational: return "variational";
    default: return "auto";
  }
}

/// Options that only the variational method takes, and those that it does not.
void check_options(const SolveOptions& options, const Problem& problem) {
  const bool on_cells = options.search_starts > 0 || takes_variational(options.method, problem.contact);
  if (on_cells && numeric::precision_for(options.common.digits) != numeric::Digits::sixteen) {
    throw bad_command_line("--digits: out of range", "the variational method works in double, 16 digits at most",
                           std::to_string(options.common.digits));
  }
  for (const auto& [option, given] : {std::pair("--cells", options.cells), {"--iterations", options.iterations}}) {
    if (on_cells || !given) continue;
    throw bad_command_line(
        std::string(option) + ": method without cells",
        "it goes with --method variational, with auto where that takes it, and with --search-solutions",
        "--method " + name_of(options.method));
  }
}

numeric::VariationalOptions variational_options(const SolveOptions& options) {
  numeric::VariationalOptions result;
  if (options.cells) result.cells = static_cast<std::size_t>(*options.cells);
  if (options.iterations) result.most_steps = *options.iterations;
  return result;
}

/// A bar that follows one solve, or a search, on cells.
std::function<void(std::size_t, std::size_t)> follow(Progress& progress, const std::size_t& done) {
  return [&progress, &done](std::size_t part, std::size_t whole) {
    progress.show(done, static_cast<double>(part) / static_cast<double>(whole));
  };
}

SolveReport solve_shown(const SolveOptions& options, const Problem& problem, ReportWanted report) {
  Solver::Wanted wanted{options.method, std::move(report), variational_options(options)};
  std::optional<Progress> progress;
  constexpr std::size_t done = 0;
  if (takes_variational(options.method, problem.contact)) {
    wanted.variational.progress = follow(progress.emplace(1), done);
  }
  return Solver(std::move(wanted)).solve(problem);
}

ExitCode solve_once(const SolveOptions& options, const Problem& problem) {
  ReportWanted wanted{options.common.digits, {}, options.samples};
  if (!options.at.empty()) wanted.at = parse_list("--at", options.at, max_places);
  const Format format = options.common.format;
  if (format == Format::csv && wanted.at.empty() && wanted.samples == 0) wanted.samples = csv_samples;

  Output output(options.common.output);
  const SolveReport report = solve_shown(options, problem, std::move(wanted));
  if (!report.why_not.empty()) throw inapplicable(problem, options.method, report.why_not);
  switch (format) {
    case Format::json: write_solve_json(problem, report, output); break;
    case Format::csv: write_solve_csv(report, output); break;
    default: write_solve_text(problem, report, output); break;
  }
  output.commit();
  warn(problem.file, report.warnings);
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
  return {problem.contact.with_load(load), problem.file, problem.samples};
}

ExitCode follow_loads(const SolveOptions& options, const Problem& problem) {
  const std::vector<Rational> loads = load_list(options.load_steps);
  Output output(options.common.output);
  std::vector<LoadStep> steps;
  {
    Progress progress(loads.size());
    std::size_t done = 0;
    Solver::Wanted wanted{options.method, {options.common.digits}, variational_options(options)};
    wanted.variational.progress = follow(progress, done);
    Solver solver(std::move(wanted));
    for (const Rational& load : loads) {
      steps.push_back({full_number(load, options.common.digits), solver.solve(with_load(problem, load))});
      progress.show(++done);
    }
  }
  const auto applies = [](const LoadStep& step) { return step.report.why_not.empty(); };
  if (std::none_of(steps.begin(), steps.end(), applies)) {
    throw inapplicable(problem, options.method, steps.front().report.why_not);
  }
  write_load_steps(options.common.format, steps, output);
  output.commit();
  for (const LoadStep& step : steps) {
    for (const std::string& what : step.report.warnings) warn(problem.file, {"load " + step.load + ": " + what});
  }

  const auto fails = [](const LoadStep& step) { return !step.report.is_solved(); };
  const auto first = std::find_if(steps.begin(), steps.end(), fails);
  if (first == steps.end()) return ExitCode::done;
  const SolveReport& report = first->report;
  throw Failure(ExitCode::refuted,
                fmt::format("{}: {} of {} loads not solved, first of all {}: {}; what was reached is printed",
                            problem.file, std::count_if(first, steps.end(), fails), steps.size(), first->load,
                            report.why_not.empty() ? report.shortcoming : report.why_not));
}

/// Not empty: there is no solution, and why.
std::string nothing_found(const SearchReport& report) {
  if (report.solutions.empty()) return fmt::format("none of {} starts led to one", report.starts);
  for (const FoundReport& found : report.solutions) {
    if (found.variational.is_solved() || found.refined) return "";
  }
  return report.solutions.front().variational.shortcoming;
}

SearchReport search_shown(const SolveOptions& options, const Problem& problem) {
  numeric::VariationalOptions variational = variational_options(options);
  numeric::SolutionSearch found;
  {
    Progress progress(1);
    constexpr std::size_t done = 0;
    variational.progress = follow(progress, done);
    found = numeric::search_solutions(problem.contact, options.search_starts, variational);
  }
  if (!found.why_not.empty()) throw inapplicable(problem, options.method, found.why_not);
  SearchReport report{found.starts, found.unsolved, found.refinements, {}, uniqueness(problem.contact), {}, {}};
  const ReportWanted wanted{options.common.digits};
  for (const numeric::FoundSolution& solution : found.solutions) {
    FoundReport shown{solution.times, report_of_cells(problem, *solution.variational, wanted), std::nullopt};
    if (solution.refined) shown.refined = make_report(problem, *solution.refined, wanted);
    if (shown.refined && !shown.refined->is_solved()) shown.refined.reset();
    const std::string number = std::to_string(report.solutions.size() + 1);
    for (const std::string& what : shown.variational.warnings) {
      report.warnings.push_back("solution " + number + ": " + what);
    }
    report.solutions.push_back(std::move(shown));
  }
  report.shortcoming = nothing_found(report);
  return report;
}

ExitCode search(const SolveOptions& options, const Problem& problem) {
  Output output(options.common.output);
  const SearchReport report = search_shown(options, problem);
  switch (options.common.format) {
    case Format::json: write_search_json(problem, report, output); break;
    case Format::csv: write_search_csv(report, output); break;
    default: write_search_text(problem, report, output); break;
  }
  output.commit();
  warn(problem.file, report.warnings);
  if (report.shortcoming.empty()) return ExitCode::done;
  throw Failure(ExitCode::refuted,
                fmt::format("{}: the search found no solution: {}", problem.file, report.shortcoming));
}

}  // namespace

ExitCode run(const SolveOptions& options) {
  const Problem problem = read_problem(options.problem);
  check_options(options, problem);
  if (options.search_starts > 0) return search(options, problem);
  return options.load_steps.empty() ? solve_once(options, problem) : follow_loads(options, problem);
}

}  // namespace steadyslide::app
