// steadyslide solve

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>

#include "app/commands/command_line.hpp"
#include "app/commands/solve_options.hpp"
#include "app/commands/solver.hpp"
#include "app/embedded.hpp"
#include "app/gnuplot/gnuplot.hpp"
#include "app/results/solution_figure.hpp"
#include "app/results/solve_writers.hpp"
#include "app/terminal/memory_file.hpp"
#include "app/terminal/progress.hpp"
#include "enclosure/loads/tolerance_band.hpp"
#include "library/proof/certificate.hpp"

namespace steadyslide::app {
namespace {

Failure inapplicable(const Problem& problem, Method method, const std::string& reason) {
  if (method == Method::closed_form) {
    return bad_command_line("--method closed-form: no closed form applies; " + reason);
  }
  return {ExitCode::bad_input, problem.file + ": " + reason};
}

/// A progress bar for one solve on cells.
std::function<void(std::size_t, std::size_t)> follow(Progress& progress) {
  return [&progress](std::size_t part, std::size_t whole) { progress.show(part, whole); };
}

template <class Result>
void write(const SolveOptions& options, const Problem& problem, const Result& result, Output& output) {
  switch (options.common.format) {
    case Format::json: write_json(problem, result, output); break;
    case Format::csv: write_csv(problem, result, output); break;
    default: write_text(problem, result, output); break;
  }
  output.commit();
  warn(problem.file, result.warnings);
}

/// With --verbose, prints which method has solved the problem, and why it was chosen.
void explain(const SolveOptions& options, const Problem& problem, const SolutionText& solution) {
  if (!options.verbose) return;
  const auto choice = choice_of(options.method, problem.contact, options.certify, options.common.digits);
  print_message(fmt::format("{}: method {}: {}", problem.file, solution.method,
                            solution.instead.empty() ? choice.reason : solution.instead));
}

/// Has steadyslide-check, beside this program, prove a certificate. Returns its last line. Throws Failure if it is not
/// proved.
std::string checked_again(const std::string& certificate) {
  const MemoryFile file(certificate), said;
  std::error_code unknown;
  std::string program = (std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path() / "steadyslide-check");
  if (!std::filesystem::exists(program, unknown))
    throw Failure(ExitCode::failed,
                  "not proved: the program that proves it is missing; it is beside this one; '" + program + "'");
  boost::replace_all(program, "'", "'\\''");
  const int status = std::system(fmt::format("'{}' {} > {} 2>&1", program, file.path(), said.path()).c_str());
  std::string text = said.text();
  text.erase(text.find_last_not_of('\n') + 1);
  text = text.substr(text.rfind('\n') + 1);
  if (status != 0) throw Failure(ExitCode::refuted, "not proved: " + text);
  return text.substr(0, text.rfind(" ("));
}

SolutionText solve_shown(const SolveOptions& options, const Problem& problem, SolutionWanted solution) {
  Solver::Wanted wanted{
      options.method,
      std::move(solution),
      options.variational(),
      options.cells || options.accuracy,
      options.certify && !problem.contact.body().period(),  // steadyslide-check proves periodic contact
      false,
      options.jobs};
  std::optional<Progress> progress;
  if (takes_variational(options.method, problem.contact, options.certify, options.common.digits))
    wanted.variational.progress = follow(progress.emplace(1));
  SolutionText text = Solver(std::move(wanted)).solve(problem);
  explain(options, problem, text);
  return text;
}

Failure unsolved(const Problem& problem, const SolutionText& solution) {
  const char* what = solution.proof || solution.bound ? "" : "the solve did not converge: ";
  return {ExitCode::refuted,
          fmt::format("{}: {}{}; what was reached is printed", problem.file, what, solution.failed_condition)};
}

/// Returns the file of the picture and requests its samples, if there is to be a picture. Fails if gnuplot is missing.
std::optional<Output> started_plot(const SolveOptions& options, SolutionWanted& wanted) {
  if (!options.plot) return std::nullopt;
  run_gnuplot("");
  wanted.curve = true;
  return std::optional<Output>(std::in_place, *options.plot);
}

ExitCode solve_both_directions(const SolveOptions& options, const Problem& problem) {
  SolutionWanted wanted = solution_wanted(options);
  Output output(options.common.output);
  std::optional<Output> plot = started_plot(options, wanted);
  const Problem turned{problem.contact.with_sliding(opposite(problem.contact.sliding())), problem.file,
                       problem.measured, problem.friction_file, problem.units};
  BothText both{solve_shown(options, problem, wanted), solve_shown(options, turned, wanted), {}};
  for (const auto& [way, solution] : {std::pair(&problem, &both.as_given), {&turned, &both.opposite}}) {
    if (!solution->reason.empty()) throw inapplicable(problem, options.method, solution->reason);
    for (const std::string& what : solution->warnings) {
      both.warnings.push_back(fmt::format("sliding towards {}: {}", name_of(way->contact.sliding()), what));
    }
  }
  if (plot) plot->write(rendered_picture(solution_figure(problem, turned, both), picture_of(*options.plot)));
  write(options, problem, both, output);
  if (plot) plot->commit();
  for (const SolutionText* solution : {&both.as_given, &both.opposite}) {
    if (!solution->is_solved()) throw unsolved(problem, *solution);
  }
  return ExitCode::done;
}

ExitCode solve_once(const SolveOptions& options, const Problem& problem) {
  SolutionWanted wanted = solution_wanted(options);
  Output output(options.common.output);
  std::optional<Output> certificate;
  if (options.certificate) certificate.emplace(*options.certificate);
  std::optional<Output> plot = started_plot(options, wanted);
  SolutionText solution = solve_shown(options, problem, std::move(wanted));
  if (!solution.reason.empty()) throw inapplicable(problem, options.method, solution.reason);
  if (options.tolerance && solution.is_solved()) {
    solution.tolerance = tolerance_text(problem.contact, *options.tolerance, solution.resultants);
  }
  if (plot) plot->write(rendered_picture(solution_figure(problem, solution), picture_of(*options.plot)));
  const bool periodic = problem.contact.body().period().has_value();
  library::PeriodicCertificate claims;
  if (options.certify && periodic) {
    claims = library::periodic_certificate(problem.contact, options.common.digits);
    if (claims.text.empty()) throw bad_command_line("--certify: no certificate", claims.reason, problem.file);
  }
  write(options, problem, solution, output);
  if (plot) plot->commit();
  if (solution.is_solved()) {
    if (options.certify && periodic) print_message(problem.file + ": " + checked_again(claims.text));
    if (certificate && !periodic)
      claims.text = solution.proof ? solution.proof->certificate : solution.bound->certificate;
    if (certificate) certificate->write(claims.text);
    if (certificate) certificate->commit();
    return ExitCode::done;
  }
  throw unsolved(problem, solution);
}

struct FollowedLoads {
  std::vector<LoadStep> steps;
  std::string certificate;  ///< for two loads between which one contact set is proved throughout
};

FollowedLoads solved_steps(const SolveOptions& options, const Problem& problem, const std::vector<Rational>& loads) {
  std::vector<LoadStep> steps;
  Progress progress(loads.size());
  SolutionWanted solution{options.common.digits};
  solution.over = options.over;
  Solver::Wanted wanted{options.method,        std::move(solution),
                        options.variational(), options.cells || options.accuracy,
                        options.certify,       options.certificate.has_value(),
                        options.jobs};
  wanted.variational.progress = follow(progress);
  Solver solver(std::move(wanted));
  for (const Rational& load : loads) {
    const Problem loaded{problem.contact.with_load(load), problem.file, problem.measured, problem.friction_file,
                         problem.units};
    LoadStep step{full_number(load, options.common.digits), solver.solve(loaded), {}};
    explain(options, loaded, step.solution);
    if (options.certify && !steps.empty()) {
      const Rational& before = loads[steps.size() - 1];
      if (before != load)
        step.until = solver.certify_load_range(problem, std::min(before, load), std::max(before, load));
    }
    steps.push_back(std::move(step));
    progress.next();
  }
  const bool is_one_branch = options.certificate && steps[1].until.size() == 1 && steps[1].until[0].is_proved();
  return {std::move(steps), is_one_branch ? solver.loads_certificate(problem) : ""};
}

ExitCode follow_loads(const SolveOptions& options, const Problem& problem) {
  const std::vector<Rational> loads = load_list(options.load_steps);
  if (options.certificate && (loads.size() != 2 || loads[0] >= loads[1])) {
    throw bad_command_line("--load-steps: no interval",
                           "a certificate is for all loads between two, the smaller one first", options.load_steps);
  }
  Output output(options.common.output);
  std::optional<Output> certificate;
  if (options.certificate) certificate.emplace(*options.certificate);
  const auto [steps, proved] = solved_steps(options, problem, loads);
  if (std::ranges::none_of(steps, [](const LoadStep& step) { return step.solution.reason.empty(); })) {
    throw inapplicable(problem, options.method, steps.front().solution.reason);
  }
  write_load_steps(options.common.format, steps, options.certify, output);
  output.commit();
  for (const auto& [load, solution, until] : steps) {
    for (const std::string& what : solution.warnings) warn(problem.file, {"load " + load + ": " + what});
  }

  const auto fails = [](const LoadStep& step) { return !step.solution.is_solved(); };
  const auto first = std::ranges::find_if(steps, fails);
  if (first == steps.end()) {
    for (const LoadStep& step : steps) {
      const auto open = std::ranges::find_if(step.until, &StretchText::is_open);
      if (open == step.until.end()) continue;
      throw Failure(ExitCode::refuted, fmt::format("{}: not proved between the loads {} and {}: {}", problem.file,
                                                   open->from, open->to, open->words));
    }
    if (certificate && proved.empty()) {
      const StretchText& event = *std::ranges::find_if_not(steps[1].until, &StretchText::is_proved);
      throw Failure(ExitCode::refuted, fmt::format("{}: no certificate: an event between the loads {} and {}: {}",
                                                   problem.file, event.from, event.to, event.words));
    }
    if (certificate) certificate->write(proved);
    if (certificate) certificate->commit();
    return ExitCode::done;
  }
  const SolutionText& failed = first->solution;
  throw Failure(ExitCode::refuted,
                fmt::format("{}: {} of {} loads not solved, first of all {}: {}; what was reached is printed",
                            problem.file, std::ranges::count_if(steps, fails), steps.size(), first->load,
                            failed.reason.empty() ? failed.failed_condition : failed.reason));
}

ExitCode run_solve(const Given& given) {
  const SolveOptions options = solve_options(given);
  const Problem problem = read_problem(given.text("PROBLEM"));
  check_method(options, problem);
  if (options.tolerance) {
    const Tolerance& most = *options.tolerance;
    checked(most.friction == 0 ? "--tolerance-profile" : "--tolerance-friction",
            [&] { return enclosure::ToleranceBand(problem.contact, most.profile, most.friction); });
  }
  if (options.both_directions) return solve_both_directions(options, problem);
  return options.load_steps.empty() ? solve_once(options, problem) : follow_loads(options, problem);
}

}  // namespace

Command solve_command() {
  return {"solve", std::string(embedded::help_solve), solve_option_list(), run_solve,
          std::string(embedded::help_problem).append("\n").append(embedded::help_solve_manual)};
}

}  // namespace steadyslide::app
