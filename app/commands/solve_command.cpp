// steadyslide solve

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "app/commands/command_line.hpp"
#include "app/commands/solver.hpp"
#include "app/embedded.hpp"
#include "app/gnuplot/gnuplot.hpp"
#include "app/results/solution_figure.hpp"
#include "app/results/solve_writers.hpp"
#include "app/terminal/progress.hpp"
#include "library/problem_file/surface_files.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t max_places = 100000;
constexpr std::size_t max_loads = 10000;
constexpr int csv_samples = 101;
/// What is proved beyond that takes minutes, unless the solution has a closed form.
constexpr int most_digits_of_integrals = 200;
constexpr std::initializer_list<Format> formats{Format::text, Format::json, Format::csv};

struct SolveOptions {
  CommonOptions common;
  std::string method_name;
  Method method;
  std::string at;  ///< a list; empty: none
  std::optional<std::string> at_file;
  bool both_directions;
  int samples;             ///< 0: none
  std::string load_steps;  ///< a list; empty: the file's load
  int search_starts;       ///< of a search for several solutions; 0: one solve
  std::optional<int> cells;
  std::optional<int> iterations;
  bool certify;
  std::optional<std::string> certificate;  ///< a file
  std::optional<std::string> plot;         ///< a file
  FieldWanted field;

  numeric::VariationalOptions variational() const {
    numeric::VariationalOptions result;
    if (cells) result.cells = static_cast<std::size_t>(*cells);
    if (iterations) result.most_steps = *iterations;
    return result;
  }
};

std::string list(const Given& given, const std::string& option) {
  if (!given.has(option)) return "";
  if (given.text(option).empty()) throw bad_command_line(option + ": no value", "it is a list", "");
  return given.text(option);
}

/// As the file's name ends.
Picture picture_of(const std::string& file) {
  const auto found = std::ranges::find_if(
      picture_names, [&](std::string_view name) { return file.ends_with("." + std::string(name)); });
  if (found != picture_names.end()) return static_cast<Picture>(found - picture_names.begin());
  throw bad_command_line("--plot: unknown kind of picture", "its name ends in .svg, .pdf or .png", file);
}

void refuse_conflicts(const Given& given, const SolveOptions& options) {
  const auto refuse = [&](const std::string& option, std::initializer_list<const char*> others, const char* rule) {
    for (const char* other : others) {
      if (given.has(other)) throw bad_command_line(option + ": conflicting option", rule, other);
    }
  };
  if (!options.load_steps.empty()) {
    refuse("--load-steps", {"--at", "--at-file", "--samples"}, "samples are those of one load");
    refuse("--load-steps", {"--stress-at", "--loads-on", "--max-stress"}, "stresses and forces are those of one load");
  }
  if (options.plot) refuse("--plot", {"--load-steps", "--search-solutions"}, "a picture shows one solution");
  if (options.certify) refuse("--certify", {"--max-stress"}, "the largest stress is not proved");
  if (given.has("--depth") && !given.has("--max-stress")) {
    throw bad_command_line("--max-stress: missing", "--depth is that of the largest stress", "--depth");
  }
  if (options.common.format == Format::csv) {
    constexpr const char* rule = "a CSV file is one table";
    if (given.has("--stress-at")) {
      refuse("--stress-at", {"--loads-on", "--max-stress", "--at", "--at-file", "--samples"}, rule);
    }
    if (given.has("--loads-on")) refuse("--loads-on", {"--max-stress", "--at", "--at-file", "--samples"}, rule);
    if (given.has("--max-stress")) refuse("--max-stress", {"--at", "--at-file", "--samples"}, rule);
  }
  if (options.certify) refuse("--certify", {"--search-solutions"}, "it proves one solution");
  if (options.both_directions) {
    refuse("--both-directions", {"--load-steps", "--search-solutions"}, "it is for one solution of each direction");
    refuse("--both-directions", {"--certificate"}, "a certificate is of one direction");
    refuse("--both-directions", {"--plot"}, "a picture shows one solution");
    refuse("--both-directions", {"--stress-at", "--loads-on", "--max-stress"},
           "stresses and forces are those of one direction");
  }
  if (options.search_starts == 0) return;
  refuse("--search-solutions",
         {"--at", "--at-file", "--samples", "--load-steps", "--stress-at", "--loads-on", "--max-stress"},
         "it compares contact zones and resultants under the file's load");
  if (options.method == Method::closed_form || options.method == Method::riemann_hilbert) {
    throw bad_command_line("--search-solutions: conflicting option", "it searches by the variational method",
                           "--method " + options.method_name);
  }
}

FieldWanted field_wanted(const Given& given) {
  FieldWanted wanted;
  if (const auto file = given.name("--stress-at", "file")) wanted.points = read_depth_points(*file);
  if (const auto file = given.name("--loads-on", "file")) wanted.mesh = std::make_shared<MeshFile>(read_mesh(*file));
  wanted.largest_stress = given.has("--max-stress");
  if (!given.has("--depth")) return wanted;
  const std::string text = given.text("--depth");
  const std::vector<Rational> depth = parse_list("--depth", text, 1);
  if (depth[0] < 0) throw bad_command_line("--depth: negative", "a depth is at least 0", text);
  wanted.depth = depth[0];
  return wanted;
}

SolveOptions read(const Given& given) {
  SolveOptions options;
  options.certificate = given.name("--certificate", "file");
  options.plot = given.name("--plot", "file");
  if (options.plot) picture_of(*options.plot);
  options.certify = given.has("--certify") || options.certificate;
  options.common = given.common(16, formats, options.certify ? most_proved_digits : most_digits);
  options.method_name = given.has("--method") ? given.text("--method") : "auto";
  options.method = checked("--method", [&] { return method_named(options.method_name); });
  options.at = list(given, "--at");
  options.at_file = given.name("--at-file", "file");
  options.both_directions = given.has("--both-directions");
  options.load_steps = list(given, "--load-steps");
  options.samples = given.count("--samples", 1, 100000).value_or(0);
  options.cells = given.count("--cells", numeric::fewest_cells, numeric::most_cells);
  options.iterations = given.count("--iterations", 1, 10000);
  options.search_starts = given.count("--search-solutions", 1, 1000).value_or(0);
  refuse_conflicts(given, options);
  options.field = field_wanted(given);
  return options;
}

/// Options that only the variational method takes, and those that it does not.
void check_method(const SolveOptions& options, const Problem& problem) {
  const bool on_cells =
      options.search_starts > 0 || takes_variational(options.method, problem.contact, options.certify);
  if (on_cells && numeric::precision_for(options.common.digits) != numeric::Digits::sixteen) {
    throw bad_command_line("--digits: out of range", "the variational method works in double, 16 digits at most",
                           std::to_string(options.common.digits));
  }
  if (on_cells && options.certify && !options.load_steps.empty()) {
    throw bad_command_line("--load-steps: method without a proof of contact",
                           "with --certify it goes with closed-form and riemann-hilbert",
                           "--method " + options.method_name);
  }
  if (on_cells && options.certify && options.field.any()) {
    throw bad_command_line("--certify: method without proved stresses and nodal forces",
                           "with them it goes with closed-form and riemann-hilbert", "--method " + options.method_name);
  }
  if (options.field.largest_stress && !problem.contact.elasticity().half_space()) {
    throw bad_command_line("--max-stress: no von Mises stress", "it needs the half-space's poisson in place of gamma",
                           problem.file);
  }
  if (options.common.digits > most_digits_of_integrals && !numeric::closed_form<double>(problem.contact).solution) {
    throw bad_command_line(
        "--digits: out of range",
        fmt::format("at most {} are proved of a solution without closed form", most_digits_of_integrals),
        std::to_string(options.common.digits));
  }
  for (const auto& [option, given] : {std::pair("--cells", options.cells), {"--iterations", options.iterations}}) {
    if (on_cells || !given) continue;
    throw bad_command_line(
        std::string(option) + ": method without cells",
        "it goes with --method variational, with auto where that takes it, and with --search-solutions",
        "--method " + options.method_name);
  }
}

Failure inapplicable(const Problem& problem, Method method, const std::string& reason) {
  if (method == Method::closed_form) {
    return bad_command_line("--method closed-form: no closed form applies; " + reason);
  }
  return {ExitCode::bad_input, problem.file + ": " + reason};
}

/// A bar that follows one solve, or a search, on cells.
std::function<void(std::size_t, std::size_t)> follow(Progress& progress) {
  return [&progress](std::size_t part, std::size_t whole) { progress.show(part, whole); };
}

template <class Result>
void write(Format format, const Problem& problem, const Result& result, Output& output) {
  switch (format) {
    case Format::json: write_json(problem, result, output); break;
    case Format::csv: write_csv(problem, result, output); break;
    default: write_text(problem, result, output); break;
  }
  output.commit();
  warn(problem.file, result.warnings);
}

SolutionText solve_shown(const SolveOptions& options, const Problem& problem, SolutionWanted solution) {
  Solver::Wanted wanted{options.method, std::move(solution), options.variational(), options.certify};
  std::optional<Progress> progress;
  if (takes_variational(options.method, problem.contact, options.certify))
    wanted.variational.progress = follow(progress.emplace(1));
  return Solver(std::move(wanted)).solve(problem);
}

/// The places of --at, then those of --at-file.
SolutionWanted samples_wanted(const SolveOptions& options) {
  SolutionWanted wanted{options.common.digits, {}, options.samples};
  if (!options.at.empty()) wanted.at = parse_list("--at", options.at, max_places);
  if (options.at_file) {
    for (Rational& x : library::read_places(*options.at_file, max_places)) wanted.at.push_back(std::move(x));
  }
  wanted.field = options.field;
  const bool any_samples = !wanted.at.empty() || wanted.samples > 0 || wanted.field.any();
  if (options.common.format == Format::csv && !any_samples) wanted.samples = csv_samples;
  return wanted;
}

Failure unsolved(const Problem& problem, const SolutionText& solution) {
  const char* what = solution.proof || solution.bound ? "" : "the solve did not converge: ";
  return {ExitCode::refuted,
          fmt::format("{}: {}{}; what was reached is printed", problem.file, what, solution.failed_condition)};
}

ExitCode solve_both_directions(const SolveOptions& options, const Problem& problem) {
  const SolutionWanted wanted = samples_wanted(options);
  Output output(options.common.output);
  const Problem turned{problem.contact.with_sliding(opposite(problem.contact.sliding())), problem.file,
                       problem.measured};
  BothText both{solve_shown(options, problem, wanted), solve_shown(options, turned, wanted), {}};
  for (const auto& [way, solution] : {std::pair(&problem, &both.as_given), {&turned, &both.opposite}}) {
    if (!solution->reason.empty()) throw inapplicable(problem, options.method, solution->reason);
    for (const std::string& what : solution->warnings) {
      both.warnings.push_back(fmt::format("sliding towards {}: {}", name_of(way->contact.sliding()), what));
    }
  }
  write(options.common.format, problem, both, output);
  for (const SolutionText* solution : {&both.as_given, &both.opposite}) {
    if (!solution->is_solved()) throw unsolved(problem, *solution);
  }
  return ExitCode::done;
}

ExitCode solve_once(const SolveOptions& options, const Problem& problem) {
  SolutionWanted wanted = samples_wanted(options);
  Output output(options.common.output);
  std::optional<Output> certificate;
  if (options.certificate) certificate.emplace(*options.certificate);
  std::optional<Output> plot;
  if (options.plot) {
    run_gnuplot("");  // without gnuplot the work would be for nothing
    plot.emplace(*options.plot);
    wanted.curve = true;
  }
  const SolutionText solution = solve_shown(options, problem, std::move(wanted));
  if (!solution.reason.empty()) throw inapplicable(problem, options.method, solution.reason);
  if (plot) plot->write(drawn(solution_figure(problem, solution), picture_of(*options.plot)));
  write(options.common.format, problem, solution, output);
  if (plot) plot->commit();
  if (solution.is_solved()) {
    if (certificate) certificate->write(solution.proof ? solution.proof->certificate : solution.bound->certificate);
    if (certificate) certificate->commit();
    return ExitCode::done;
  }
  throw unsolved(problem, solution);
}

std::vector<Rational> load_list(const std::string& text) {
  std::vector<Rational> loads = parse_list("--load-steps", text, max_loads);
  for (const Rational& load : loads) {
    if (load > 0) continue;
    throw bad_command_line("--load-steps: load out of range", "the load is positive", to_string(load));
  }
  return loads;
}

struct FollowedLoads {
  std::vector<LoadStep> steps;
  std::string certificate;  ///< of two loads between which one contact set is proved throughout
};

FollowedLoads solved_steps(const SolveOptions& options, const Problem& problem, const std::vector<Rational>& loads) {
  std::vector<LoadStep> steps;
  Progress progress(loads.size());
  Solver::Wanted wanted{
      options.method, {options.common.digits}, options.variational(), options.certify, options.certificate.has_value()};
  wanted.variational.progress = follow(progress);
  Solver solver(std::move(wanted));
  for (const Rational& load : loads) {
    const Problem loaded{problem.contact.with_load(load), problem.file, problem.measured};
    LoadStep step{full_number(load, options.common.digits), solver.solve(loaded), {}};
    if (options.certify && !steps.empty()) {
      const Rational& before = loads[steps.size() - 1];
      if (before != load) step.until = solver.between(problem, std::min(before, load), std::max(before, load));
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

/// Not empty: there is no solution, and why.
std::string nothing_found(const SearchText& search) {
  if (search.solutions.empty()) return fmt::format("none of {} starts led to one", search.starts);
  for (const FoundText& found : search.solutions) {
    if (found.variational.is_solved() || found.refined) return "";
  }
  return search.solutions.front().variational.failed_condition;
}

numeric::SolutionSearch search_shown(const SolveOptions& options, const Problem& problem) {
  numeric::VariationalOptions variational = options.variational();
  Progress progress(1);
  variational.progress = follow(progress);
  return numeric::search_solutions(problem.contact, options.search_starts, variational);
}

ExitCode search(const SolveOptions& options, const Problem& problem) {
  Output output(options.common.output);
  const numeric::SolutionSearch found = search_shown(options, problem);
  if (!found.reason.empty()) throw inapplicable(problem, options.method, found.reason);
  SearchText text{found.starts, found.unsolved, found.refinements, {}, uniqueness(problem.contact), {}, {}};
  const SolutionWanted wanted{options.common.digits};
  for (const numeric::FoundSolution& solution : found.solutions) {
    FoundText shown{solution.times, text_on_cells(problem, *solution.variational, wanted), std::nullopt};
    if (solution.refined) shown.refined = solution_text(problem, *solution.refined, wanted);
    if (shown.refined && !shown.refined->is_solved()) shown.refined.reset();
    for (const std::string& what : shown.variational.warnings) {
      text.warnings.push_back(fmt::format("solution {}: {}", text.solutions.size() + 1, what));
    }
    text.solutions.push_back(std::move(shown));
  }
  text.failed_condition = nothing_found(text);
  write(options.common.format, problem, text, output);
  if (text.failed_condition.empty()) return ExitCode::done;
  throw Failure(ExitCode::refuted,
                fmt::format("{}: the search found no solution: {}", problem.file, text.failed_condition));
}

ExitCode run_solve(const Given& given) {
  const SolveOptions options = read(given);
  const Problem problem = read_problem(given.text("PROBLEM"));
  check_method(options, problem);
  if (options.search_starts > 0) return search(options, problem);
  if (options.both_directions) return solve_both_directions(options, problem);
  return options.load_steps.empty() ? solve_once(options, problem) : follow_loads(options, problem);
}

}  // namespace

Command solve_command() {
  return {
      "solve", std::string(embedded::help_solve).append(embedded::help_problem),
      with_common(
          {problem_argument(),
           {"--method", "METHOD", "auto, closed-form, riemann-hilbert or variational", Option::Kind::text,
            "auto closed-form riemann-hilbert variational"},
           {"--at", "LIST", "Results at these x, in your units; may lie outside the support"},
           {"--at-file", "FILE", "The same at the x in FILE, one a line; # begins a comment"},
           {"--both-directions", "", "The solution with the indenter sliding the other way, too", Option::Kind::flag},
           {"--samples", "N", "Results at N places in each contact component and gap, 1 to 100000"},
           {"--cells", "N", "Equal cells on the support, 16 to 4194304; default 4096: variational only"},
           {"--iterations", "N",
            "Most steps of the active sets on each mesh, 1 to 10000; default 100: variational only"},
           {"--plot", "FILE", "Draw indenter, surface and tractions into FILE.svg, .pdf or .png, by gnuplot"},
           {"--stress-at", "FILE", "Stresses below the surface at the points x,z of a table, z > 0 into the body"},
           {"--loads-on", "FILE", "Nodal forces on a mesh of the surface: a table of nodes x, or x,order"},
           {"--max-stress", "", "The largest von Mises stress in the body, and where", Option::Kind::flag},
           {"--depth", "Z", "At depths of at least Z; default 0, or where stresses have no bound width/100"},
           {"--load-steps", "LIST", "The contact under each of these loads, one row for each component"},
           {"--search-solutions", "N",
            "Start from N contact sets, 1 to 1000: do all lead to one solution? By the variational method"},
           certify_option("Prove the solution, enclose every number in ball arithmetic; exit code 1 if unproved"),
           {"--certificate", "FILE", "Write the proof's certificate, for steadyslide-check; implies --certify"}},
          "Significant digits, 1 to 100, with --certify 1000; default 16", formats),
      run_solve};
}

}  // namespace steadyslide::app
