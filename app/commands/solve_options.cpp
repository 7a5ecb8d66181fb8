#include "app/commands/solve_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <thread>

#include "library/problem_file/surface_files.hpp"
#include "library/proof/certificate.hpp"
#include "numeric/closed_form/closed_form.hpp"
#include "numeric/interior/average_stress.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t max_places = 100000;
constexpr std::size_t max_loads = 10000;
constexpr int csv_samples = 101;
/// More proved digits take minutes, unless the solution has a closed form.
constexpr int most_digits_of_integrals = 200;
constexpr std::initializer_list<Format> formats{Format::text, Format::json, Format::csv};

std::string list(const Given& given, const std::string& option) {
  if (!given.has(option)) return "";
  if (given.text(option).empty()) throw bad_command_line(option + ": no value", "it is a list", "");
  return given.text(option);
}

/// A combination of options, or of options and problem, that is not allowed.
struct Refusal {
  bool applies;
  std::string what, rule, value;
};

void refuse(std::initializer_list<Refusal> table) {
  for (const auto& [applies, what, rule, value] : table) {
    if (applies) throw bad_command_line(what, rule, value);
  }
}

void refuse_conflicts(const Given& given, const SolveOptions& options) {
  const auto conflict = [&](const std::string& option, bool has_option, std::initializer_list<const char*> others,
                            const char* rule) {
    const auto other = std::ranges::find_if(others, [&](const char* one) { return given.has(one); });
    const bool found = has_option && other != others.end();
    return Refusal{found, option + ": conflicting option", rule, found ? *other : ""};
  };
  const bool follows = !options.load_steps.empty(), both = options.both_directions;
  const bool csv = options.common.format == Format::csv;
  constexpr const char* one_table = "a CSV file is one table";
  const std::initializer_list<const char*> no_intervals{"--load-steps", "--both-directions"};
  constexpr const char* one_load_and_direction = "the intervals are those of one load and direction";
  refuse({
      conflict("--load-steps", follows, {"--at", "--at-file", "--samples"}, "samples are those of one load"),
      conflict("--load-steps", follows,
               {"--stress-at", "--displacement-at", "--interfaces", "--loads-on", "--max-stress"},
               "stresses and forces are those of one load"),
      conflict("--plot", options.plot.has_value(), {"--load-steps"}, "a picture shows one solution"),
      {options.over && options.certify, "--over: conflicting option", "averages have estimates, no proof", "--certify"},
      {options.over && given.has("--max-stress") && options.common.digits > 16, "--over: too many digits",
       numeric::digits_of_averages, fmt::format("--digits {}", options.common.digits)},
      {given.has("--jobs") && !options.certify, "--jobs: nothing to share", "it goes with --certify",
       given.text("--jobs")},
      {given.has("--depth") && !given.has("--max-stress"), "--max-stress: missing",
       "--depth is that of the largest stress", "--depth"},
      conflict("--cells", options.cells.has_value(), {"--accuracy"}, "the accuracy chooses the cells"),
      conflict("--certify", options.certify, {"--accuracy"}, "a proof takes equal cells on the whole support"),
      conflict("--certify", options.certify, {"--displacement-at"}, "displacements have estimates, no proof"),
      conflict("--stress-at", csv && given.has("--stress-at"),
               {"--displacement-at", "--interfaces", "--loads-on", "--max-stress", "--at", "--at-file", "--samples"},
               one_table),
      conflict("--displacement-at", csv && given.has("--displacement-at"),
               {"--interfaces", "--loads-on", "--max-stress", "--at", "--at-file", "--samples"}, one_table),
      conflict("--interfaces", csv && given.has("--interfaces"),
               {"--loads-on", "--max-stress", "--at", "--at-file", "--samples"}, one_table),
      conflict("--loads-on", csv && given.has("--loads-on"), {"--max-stress", "--at", "--at-file", "--samples"},
               one_table),
      conflict("--max-stress", csv && given.has("--max-stress"), {"--at", "--at-file", "--samples"}, one_table),
      conflict("--tolerance-profile", given.has("--tolerance-profile"), no_intervals, one_load_and_direction),
      conflict("--tolerance-friction", given.has("--tolerance-friction"), no_intervals, one_load_and_direction),
      conflict("--tolerance-profile", csv && given.has("--tolerance-profile"), {"--format"}, one_table),
      conflict("--tolerance-friction", csv && given.has("--tolerance-friction"), {"--format"}, one_table),
      conflict("--both-directions", both, {"--load-steps"}, "it is for one solution of each direction"),
      conflict("--both-directions", both, {"--certificate"}, "a certificate is of one direction"),
  });
}

/// Returns the number of an option whose value is at least 0; 0 without the option.
Rational size_of(const Given& given, const std::string& option, const char* rule) {
  if (!given.has(option)) return 0;
  const std::string text = given.text(option);
  const Rational size = parse_list(option, text, 1)[0];
  if (size < 0) throw bad_command_line(option + ": negative", rule, text);
  return size;
}

std::optional<Tolerance> tolerance_wanted(const Given& given) {
  if (!given.has("--tolerance-profile") && !given.has("--tolerance-friction")) return std::nullopt;
  constexpr const char* rule = "a tolerance is at least 0";
  return Tolerance{size_of(given, "--tolerance-profile", rule), size_of(given, "--tolerance-friction", rule)};
}

std::optional<double> accuracy_wanted(const Given& given) {
  if (!given.has("--accuracy")) return std::nullopt;
  const Rational accuracy = size_of(given, "--accuracy", accuracy_rule);
  if (is_accuracy(accuracy)) return accuracy.convert_to<double>();
  throw bad_command_line("--accuracy: out of range", accuracy_rule, given.text("--accuracy"));
}

std::optional<Rational> window_wanted(const Given& given) {
  if (!given.has("--over")) return std::nullopt;
  constexpr const char* rule = "the length of a window is positive";
  const Rational length = size_of(given, "--over", rule);
  if (length > 0) return length;
  throw bad_command_line("--over: 0", rule, given.text("--over"));
}

FieldWanted field_wanted(const Given& given) {
  FieldWanted wanted;
  if (const auto file = given.name("--stress-at", "file")) wanted.points = read_depth_points(*file);
  if (const auto file = given.name("--displacement-at", "file")) wanted.displaced = read_depth_points(*file);
  if (const auto file = given.name("--loads-on", "file")) wanted.mesh = std::make_shared<MeshFile>(read_mesh(*file));
  wanted.interfaces = given.has("--interfaces");
  wanted.largest_stress = given.has("--max-stress");
  if (!given.has("--depth")) return wanted;
  wanted.depth = size_of(given, "--depth", "a depth is at least 0");
  return wanted;
}

}  // namespace

std::vector<Option> solve_option_list() {
  return with_common(
      {problem_argument(),
       {"--method", "METHOD", "auto, closed-form, riemann-hilbert or variational", Option::Kind::text,
        "auto closed-form riemann-hilbert variational"},
       {"-v,--verbose", "", "Which method was taken, and why, on the standard error output", Option::Kind::flag},
       {"--at", "LIST", "Results at these x, in your units; may lie outside the support"},
       {"--at-file", "FILE", "The same at the x in FILE, one a line; # begins a comment"},
       {"--both-directions", "", "The solution with the indenter sliding the other way, too", Option::Kind::flag},
       {"--samples", "N", "Results at N places in each contact component and gap, 1 to 100000"},
       {"--cells", "N", "Equal cells on the support, 16 to 4194304; default 4096: variational only"},
       {"--accuracy", "A", "More cells, until ends and resultants have this relative error: variational only"},
       {"--iterations", "N", "Most steps of the active sets on each mesh, 1 to 10000; default 100: variational only"},
       {"--plot", "FILE", "Draw indenter, surface and tractions into FILE.svg, .pdf or .png, by gnuplot"},
       {"--stress-at", "FILE", "Stresses at the points x,z of a table, z >= 0 into the body"},
       {"--displacement-at", "FILE", "Displacements at the points x,z of a table, up to a constant of the half-plane"},
       {"--interfaces", "", "The largest shear and tension at each interface of layers, and where", Option::Kind::flag},
       {"--loads-on", "FILE", "Nodal forces on a mesh of the surface: a table of nodes x, or x,order"},
       {"--max-stress", "", "The largest von Mises stress in the body, and where; with --certify a lower bound",
        Option::Kind::flag},
       {"--depth", "Z", "At depths of at least Z; default 0, or where stresses have no bound width/100"},
       {"--over", "LENGTH",
        "The largest mean pressure over windows of this length, inside the contact; with --max-stress also the largest "
        "stress of averages over this length"},
       {"--load-steps", "LIST", "The contact under each of these loads, one row for each component"},
       {"--tolerance-profile", "E", "Intervals of load shares and friction for all profiles within E; f must not fall"},
       {"--tolerance-friction", "D", "The same for all frictions within D"},
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
  options.verbose = given.has("--verbose");
  options.load_steps = list(given, "--load-steps");
  options.jobs = given.jobs(std::max(1U, std::thread::hardware_concurrency()));
  options.samples = given.count("--samples", 1, 100000).value_or(0);
  options.cells = given.count("--cells", numeric::fewest_cells, numeric::most_cells);
  options.iterations = given.count("--iterations", 1, 10000);
  options.accuracy = accuracy_wanted(given);
  options.over = window_wanted(given);
  refuse_conflicts(given, options);
  options.field = field_wanted(given);
  options.tolerance = tolerance_wanted(given);
  return options;
}

void check_method(const SolveOptions& options, const Problem& problem) {
  const bool on_cells = takes_variational(options.method, problem.contact, options.certify, options.common.digits);
  const Body& body = problem.contact.body();
  const FieldWanted& field = options.field;
  const bool proves_on_cells = on_cells && options.certify, half_plane = body.is_half_plane();
  const bool periodic = body.period().has_value();
  const bool layered = !body.layers().empty();
  Rational bottom = 0;
  for (const Layer& layer : body.layers()) bottom += layer.thickness;
  const auto in_base = std::ranges::find_if(field.points, [&](const DepthPoint& point) { return point.z > bottom; });
  const std::string method = "--method " + options.method_name, digits = std::to_string(options.common.digits);
  const std::string cells_rule = "it goes with --method variational, and with auto where that takes it";
  refuse({
      {on_cells && numeric::precision_for(options.common.digits) != numeric::Digits::sixteen, "--digits: out of range",
       digits_on_cells, digits},
      {proves_on_cells && !options.load_steps.empty(), "--load-steps: method without a proof of contact",
       "with --certify it goes with closed-form and riemann-hilbert", method},
      {proves_on_cells && options.field.any(), "--certify: method without proved stresses and nodal forces",
       "with them it goes with closed-form and riemann-hilbert", method},
      {options.certify && !half_plane && !periodic, "--certify: body without a proof",
       "proofs are for the half-plane, and for periodic contact", problem.file},
      {options.certify && periodic && (options.both_directions || !options.load_steps.empty()),
       "--load-steps, --both-directions: several solutions", "with a period a certificate is of one solution",
       "--certify"},
      {options.certify && periodic && options.common.digits > most_periodic_digits, "--digits: out of range",
       fmt::format("with a period at most {} are proved", most_periodic_digits), digits},
      {options.certify && periodic && !numeric::closed_form<double>(problem.contact).solution,
       "--certify: no certificate", library::no_periodic_certificate, problem.file},
      {options.tolerance && !half_plane, "--tolerance-profile, --tolerance-friction: body without a bound",
       "the bound is that of the half-plane", problem.file},
      {field.interfaces && !layered, "--interfaces: body without layers", "an interface is the lower side of a layer",
       problem.file},
      {field.has_stress() && body.symbols(), "--stress-at, --max-stress: body without a field",
       "given symbols do not tell the stresses inside", problem.file},
      {!field.displaced.empty() && !half_plane, "--displacement-at: body without a field",
       "displacements inside are those of the half-plane", problem.file},
      {field.largest_stress && options.over && !half_plane, "--over, --max-stress: body without averages",
       "averages are those of the half-plane", problem.file},
      {layered && !body.base() && in_base != field.points.end(), "--stress-at: place in the rigid base",
       "z is at most " + library::exact_text(bottom),
       in_base == field.points.end() ? "" : library::exact_text(in_base->z)},
      {options.field.largest_stress && !problem.contact.elasticity().half_space(), "--max-stress: no von Mises stress",
       "it needs the half-space's poisson in place of gamma", problem.file},
      {!options.field.displaced.empty() && !problem.contact.elasticity().half_space(),
       "--displacement-at: no displacement", "it needs the half-space's poisson in place of gamma", problem.file},
      {options.certify &&
           std::ranges::any_of(options.field.points, [](const DepthPoint& point) { return point.z == 0; }),
       "--certify: no proved stress at the surface", "with it the points of --stress-at have depths above 0", "z = 0"},
      {options.common.digits > most_digits_of_integrals && !numeric::closed_form<double>(problem.contact).solution,
       "--digits: out of range",
       fmt::format("at most {} are proved of a solution without closed form", most_digits_of_integrals), digits},
      {!on_cells && options.cells, "--cells: method without cells", cells_rule, method},
      {!on_cells && options.accuracy, "--accuracy: method without cells", cells_rule, method},
      {!on_cells && options.iterations, "--iterations: method without cells", cells_rule, method},
  });
}

SolutionWanted solution_wanted(const SolveOptions& options) {
  SolutionWanted wanted{options.common.digits, {}, options.samples};
  if (!options.at.empty()) wanted.at = parse_list("--at", options.at, max_places);
  if (options.at_file) {
    for (Rational& x : library::read_places(*options.at_file, max_places)) wanted.at.push_back(std::move(x));
  }
  wanted.field = options.field;
  wanted.over = options.over;
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
