#include "app/commands/solve_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <thread>

#include "app/commands/jobs.hpp"
#include "library/problem_file/surface_files.hpp"
#include "numeric/closed_form/closed_form.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t max_places = 100000;
constexpr std::size_t max_loads = 10000;
constexpr int csv_samples = 101;
/// What is proved beyond that takes minutes, unless the solution has a closed form.
constexpr int most_digits_of_integrals = 200;
constexpr std::initializer_list<Format> formats{Format::text, Format::json, Format::csv};

std::string list(const Given& given, const std::string& option) {
  if (!given.has(option)) return "";
  if (given.text(option).empty()) throw bad_command_line(option + ": no value", "it is a list", "");
  return given.text(option);
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
  if (given.has("--jobs") && !options.certify) {
    throw bad_command_line("--jobs: nothing to share", "it goes with --certify", given.text("--jobs"));
  }
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

}  // namespace

std::vector<Option> solve_option_list() {
  return with_common(
      {problem_argument(),
       {"--method", "METHOD", "auto, closed-form, riemann-hilbert or variational", Option::Kind::text,
        "auto closed-form riemann-hilbert variational"},
       {"--at", "LIST", "Results at these x, in your units; may lie outside the support"},
       {"--at-file", "FILE", "The same at the x in FILE, one a line; # begins a comment"},
       {"--both-directions", "", "The solution with the indenter sliding the other way, too", Option::Kind::flag},
       {"--samples", "N", "Results at N places in each contact component and gap, 1 to 100000"},
       {"--cells", "N", "Equal cells on the support, 16 to 4194304; default 4096: variational only"},
       {"--iterations", "N", "Most steps of the active sets on each mesh, 1 to 10000; default 100: variational only"},
       {"--plot", "FILE", "Draw indenter, surface and tractions into FILE.svg, .pdf or .png, by gnuplot"},
       {"--stress-at", "FILE", "Stresses below the surface at the points x,z of a table, z > 0 into the body"},
       {"--loads-on", "FILE", "Nodal forces on a mesh of the surface: a table of nodes x, or x,order"},
       {"--max-stress", "", "The largest von Mises stress in the body, and where; with --certify a lower bound",
        Option::Kind::flag},
       {"--depth", "Z", "At depths of at least Z; default 0, or where stresses have no bound width/100"},
       {"--load-steps", "LIST", "The contact under each of these loads, one row for each component"},
       {"--search-solutions", "N",
        "Start from N contact sets, 1 to 1000: do all lead to one solution? By the variational method"},
       certify_option("Prove the solution, enclose every number in ball arithmetic; exit code 1 if unproved"),
       {"--certificate", "FILE", "Write the proof's certificate, for steadyslide-check; implies --certify"},
       jobs_option("With --certify: threads")},
      "Significant digits, 1 to 100, with --certify 1000; default 16", formats);
}

SolveOptions solve_options(const Given& given) {
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
  options.jobs = jobs(given, std::max(1U, std::thread::hardware_concurrency()));
  options.samples = given.count("--samples", 1, 100000).value_or(0);
  options.cells = given.count("--cells", numeric::fewest_cells, numeric::most_cells);
  options.iterations = given.count("--iterations", 1, 10000);
  options.search_starts = given.count("--search-solutions", 1, 1000).value_or(0);
  refuse_conflicts(given, options);
  options.field = field_wanted(given);
  return options;
}

void check_method(const SolveOptions& options, const Problem& problem) {
  const bool on_cells = options.search_starts > 0 ||
                        takes_variational(options.method, problem.contact, options.certify, options.common.digits);
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

SolutionWanted solution_wanted(const SolveOptions& options) {
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

std::vector<Rational> load_list(const std::string& text) {
  std::vector<Rational> loads = parse_list("--load-steps", text, max_loads);
  for (const Rational& load : loads) {
    if (load > 0) continue;
    throw bad_command_line("--load-steps: load out of range", "the load is positive", to_string(load));
  }
  return loads;
}

Picture picture_of(const std::string& file) {
  const auto found = std::ranges::find_if(
      picture_names, [&](std::string_view name) { return file.ends_with("." + std::string(name)); });
  if (found != picture_names.end()) return static_cast<Picture>(found - picture_names.begin());
  throw bad_command_line("--plot: unknown kind of picture", "its name ends in .svg, .pdf or .png", file);
}

}  // namespace steadyslide::app
