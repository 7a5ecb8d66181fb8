// steadyslide wear

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/commands/command_line.hpp"
#include "app/commands/solve_options.hpp"
#include "app/embedded.hpp"
#include "app/gnuplot/gnuplot.hpp"
#include "app/terminal/progress.hpp"
#include "app/wear/wear_figure.hpp"
#include "app/wear/wear_record.hpp"
#include "library/problem_file/problem_file.hpp"
#include "library/sweep/random_decimals.hpp"

namespace steadyslide::app {
namespace {

using numeric::wear::WearRun;

struct WearOptions {
  numeric::wear::WearWanted wanted;
  std::optional<std::string> output, profiles, plot;
  bool resume;
};

/// Calls `act`. InvalidData that names an option becomes a Failure of the command line.
template <class Act>
void as_option(Act act) {
  try {
    act();
  } catch (const InvalidData& invalid) {
    if (invalid.field().empty()) throw;
    throw bad_command_line("--" + invalid.field() + ": " + invalid.what());
  }
}

/// Returns the number of an option; `otherwise` without it.
double number(const Given& given, const std::string& option, double otherwise) {
  if (!given.has(option)) return otherwise;
  return parse_list(option, given.text(option), 1)[0].convert_to<double>();
}

WearOptions read_options(const Given& given) {
  WearOptions options;
  if (!given.has("--distance"))
    throw bad_command_line("--distance: missing", "a run of wear has a sliding distance", "absent");
  const bool has_steps = given.has("--steps") && given.text("--steps") != "auto";
  if (has_steps && given.has("--accuracy"))
    throw bad_command_line("--steps: conflicting option", "the accuracy chooses the steps", "--accuracy");
  auto& wanted = options.wanted;
  wanted.distance = number(given, "--distance", 0);
  if (has_steps) wanted.steps = *given.count("--steps", 1, 1000000);
  wanted.accuracy = number(given, "--accuracy", wanted.accuracy);
  wanted.until = number(given, "--until", 0);
  if (const auto cells = given.count("--cells", numeric::fewest_cells, numeric::most_cells))
    wanted.cells = static_cast<std::size_t>(*cells);
  as_option([&] { check(wanted); });
  options.output = given.name("--output", "file");
  options.profiles = given.name("--profiles", "file");
  options.plot = given.name("--plot", "file");
  if (options.plot) picture_of(*options.plot);
  options.resume = given.has("--resume");
  if (options.resume && !options.output) {
    throw bad_command_line("--resume: nothing to resume", "it goes on with FILE.part of --output FILE",
                           "standard output");
  }
  return options;
}

/// The first line of FILE.part: runs with different numbers differ in it.
std::string title_of(const WearRun& run, const numeric::wear::WearWanted& wanted) {
  std::vector<double> numbers = run.process().data();
  numbers.insert(numbers.end(), {wanted.distance, static_cast<double>(wanted.steps), wanted.accuracy, wanted.until});
  const std::string_view bytes(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
  return fmt::format("# steadyslide {}, wear {:016x}\n", version, fnv1a(version, fnv1a(bytes)));
}

/// FILE.part of an output: it survives an interrupted run.
class WearPart {
 public:
  WearPart(const WearOptions& options, std::string title) : title_(std::move(title)) {
    if (!options.output) return;
    std::error_code unknown;
    const auto status = std::filesystem::status(*options.output, unknown);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) return;
    name_ = *options.output + ".part";
    if (!std::filesystem::exists(name_, unknown)) return;
    if (!options.resume) {
      throw Failure(ExitCode::bad_input, name_ +
                                             ":1: an interrupted run; --resume goes on with it; without it there "
                                             "is no such file");
    }
    std::ifstream file(name_, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (!file) throw Failure(ExitCode::failed, name_ + ": cannot be read");
    found_ = record_of(bytes, title_, name_);
  }

  /// The record of the interrupted run, if there is one.
  std::optional<WearRecord>& found() { return found_; }
  /// Saves the record if the last time was a while ago. This takes a tenth of the time at most.
  void save(const WearRecord& record) {
    const Clock::time_point now = Clock::now();
    if (name_.empty() || now < next_) return;
    write_whole(name_, bytes_of(record, title_));
    next_ = Clock::now() + std::max<Clock::duration>(pause, 9 * (Clock::now() - now));
  }
  void remove() {
    std::error_code unknown;
    if (!name_.empty()) std::filesystem::remove(name_, unknown);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds pause{200};

  std::string title_, name_;
  std::optional<WearRecord> found_;
  Clock::time_point next_ = Clock::now() + pause;
};

ExitCode run_wear(const Given& given) {
  const WearOptions options = read_options(given);
  const Problem problem = read_problem(given.text("PROBLEM"));
  if (!problem.wear) {
    throw Failure(ExitCode::bad_input, problem.file + ": wear: missing; the command wear needs the table; absent");
  }
  if (options.plot) run_gnuplot("");
  // Checked now, written at the end: an interrupted run leaves FILE.part alone.
  for (const auto* file : {&options.output, &options.profiles, &options.plot}) {
    if (*file) const Output writable(*file);
  }
  Output printed(std::nullopt);
  std::optional<WearRun> run;
  try {
    as_option([&] { run.emplace(problem.contact, *problem.wear, options.wanted); });
  } catch (const InvalidData& invalid) {
    throw Failure(ExitCode::bad_input, fmt::format("{}: {}", problem.file, invalid.what()));
  }

  WearPart part(options, title_of(*run, options.wanted));
  WearRecord record;
  if (part.found()) {
    record = std::move(*part.found());
    run->go_on(record.state, record.steps, record.step_error);
  } else {
    record.add(*run);
  }
  const auto print = [&](std::string_view rows) {
    if (options.output) return;
    printed.write(rows);
    printed.flush();
  };
  print(wear_header() + record.rows);
  {
    Progress progress(1);
    constexpr std::size_t whole = 1000;
    while (!run->is_over()) {
      const std::size_t before = record.rows.size();
      run->advance();
      ++record.steps;
      record.add(*run);
      print(std::string_view(record.rows).substr(before));
      part.save(record);
      progress.show(static_cast<std::size_t>(run->progress() * whole), whole);
    }
  }
  record.add_last_profile(run->process());
  const std::vector<double> edges = profile_edges(run->process());
  if (options.profiles) write_whole(options.profiles, profile_table(record, edges));
  if (options.plot) {
    const std::vector<double> run_in = means_over_parts(run->process().run_in_pressures());
    write_whole(options.plot, rendered_picture(wear_figure(problem, record, edges, run_in), picture_of(*options.plot)));
  }
  if (options.output) write_whole(options.output, wear_header() + record.rows);
  part.remove();
  if (run->row().failed_condition.empty()) return ExitCode::done;
  throw Failure(ExitCode::refuted,
                fmt::format("{}: not solved beyond the sliding distance {}: {}; what was reached is "
                            "printed",
                            problem.file, full_number(run->state().distance, 6), run->row().failed_condition));
}

}  // namespace

Command wear_command() {
  return {"wear",
          std::string(embedded::help_wear),
          {problem_argument(),
           {"--distance", "S", "The sliding distance; required"},
           {"--steps", "N", "auto, or so many equal steps, 1 to 1000000; default auto"},
           {"--accuracy", "X", "The largest error of an automatic step, 1e-6 to 1; default 1e-3"},
           {"--cells", "N", "Equal cells on the support, 16 to 4194304; default 4096"},
           {"--until", "X", "End earlier if so small a part of the load differs from the run-in pressure"},
           {"--resume", "", "Go on where an interrupted run has stopped: with FILE.part", Option::Kind::flag},
           {"--profiles", "FILE", "Write pressure and worn depth along x: CSV"},
           {"--plot", "FILE", "Draw worn depth and pressure into FILE.svg, .pdf or .png, by gnuplot"},
           {"-o,--output", "FILE", "Write to FILE, whole or not at all; default: standard output"}},
          run_wear};
}

}  // namespace steadyslide::app
