// The commands `verify`, which examines the ledger, and `report`, which also writes its page.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/commands/command_line.hpp"
#include "app/embedded.hpp"
#include "app/report/report_page.hpp"
#include "app/verify/coq_export.hpp"
#include "app/verify/verify_writers.hpp"
#include "proofs_checks/kit/processes.hpp"
#include "proofs_checks/kit/registry.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;

unsigned processes_of(const Given& given) { return given.jobs(checks::available_processes()); }

checks::Context context_of(const Given& given, int digits) {
  checks::Context context;
  context.digits = numeric::precision_for(digits);
  context.seed = given.seed().value_or(context.seed);
  context.quick = given.has("--quick");
  return context;
}

constexpr std::initializer_list<Format> formats{Format::text, Format::json, Format::markdown};

std::vector<checks::Claim> selected(const Given& given) {
  const std::vector<std::string> patterns = given.texts("--claim");
  for (const std::string& pattern : patterns) {
    if (!checks::select(checks::registry(), {pattern}).empty()) continue;
    throw bad_command_line("--claim: no such claim", "verify --list names them", pattern);
  }
  const std::string group = given.text("--group");
  if (group.empty()) return checks::select(checks::registry(), patterns);
  const std::vector<std::string> groups = checks::groups();
  if (std::ranges::find(groups, group) == groups.end()) {
    throw bad_command_line("--group: no such place in the paper", fmt::format("one of {}", fmt::join(groups, ", ")),
                           group);
  }
  return checks::select(checks::claims_of_group(group), patterns);
}

/// Writes a line to stderr that the next one overwrites. Call it only if stderr is a terminal.
void show_progress(const std::string& line) { std::fputs(("\r\x1b[K" + line).c_str(), stderr); }

/// Examines the claims in child processes. Shows the progress on stderr if that is a terminal.
VerifyResult examine(const checks::Context& context, unsigned processes, const std::vector<checks::Claim>& claims) {
  VerifyResult result;
  result.context = context;
  const bool on_terminal = ::isatty(STDERR_FILENO) == 1;
  result.reports = checks::run_in_processes(claims, result.context, processes,
                                            [&](std::size_t index, std::size_t total, const checks::Claim& claim) {
                                              if (on_terminal)
                                                show_progress(fmt::format("[{}/{}] {}", index + 1, total, claim.id));
                                            });
  if (on_terminal) show_progress("");
  result.notes = checks::reading_notes(result.reports);
  return result;
}

/// Makes the folder if it does not exist, and returns FOLDER/report.html.
std::string report_file(const std::string& folder) {
  make_folder(folder);
  return (std::filesystem::path(folder) / "report.html").string();
}

/// Returns the names of the figures that support a statement. The page has a sketch of its own and must be small enough
/// to be sent by mail; the other figures are in the gallery of the documentation.
std::vector<std::string> shown_figures() {
  std::vector<std::string> shown;
  for (const FigureMaker& figure : figures()) {
    const std::string& name = figure.name;
    if (name != "sketch" && name != "friction-direction" && name != "rough-surface" && name != "stress-parabola")
      shown.push_back(name);
  }
  return shown;
}

/// Returns the parts of the page besides the ledger. If the figures cannot be drawn, for example without gnuplot, the
/// page gives the reason instead.
Supplement supplement(unsigned processes) {
  Supplement parts;
  try {
    parts.figures = draw_figures(shown_figures(), processes);
  } catch (const Failure& failure) {
    if (failure.code() == ExitCode::interrupted) throw;
    parts.no_figures = fmt::format("No figures: {}.", failure.what());
  }
  parts.tables = exponent_tables();
  parts.mutants = read_mutants(embedded::mutants_csv);
  parts.made = made_now();
  return parts;
}

void write_report(const VerifyResult& result, unsigned processes, Output& output) {
  output.write(report_html(result, supplement(processes)));
  output.commit();
}

ExitCode verify(const Given& given) {
  const CommonOptions common = given.common(50, formats);
  const checks::Context context = context_of(given, common.digits);
  const unsigned processes = processes_of(given);
  const std::optional<std::string> folder = given.name("--report", "folder");
  const bool list = given.has("--list");
  if (given.has("--proof") && list)
    throw bad_command_line("--list: conflicting option", "it checks no proof", "--proof");
  if (const auto coq = given.name("--export-coq", "folder")) {
    for (const char* other : {"--list", "--claim", "--group", "--proof", "--quick", "--report", "--seed"}) {
      if (given.has(other)) {
        throw bad_command_line("--export-coq: conflicting option",
                               "it writes every decided statement and checks nothing", other);
      }
    }
    Output output(common.output);
    output.write(export_coq(*coq));
    output.commit();
    return ExitCode::done;
  }
  if (folder && list) throw bad_command_line("--list: conflicting option", "it checks nothing to report", "--report");
  const std::vector<checks::Claim> claims = selected(given);
  // The output is opened before the run, which may be long: a folder that does not exist is an error at once.
  Output output(common.output);
  if (list) {
    write_claims(common.format, claims, output);
    output.commit();
    return ExitCode::done;
  }
  std::optional<Output> page;
  if (folder) page.emplace(report_file(*folder));
  VerifyResult result = examine(context, processes, claims);
  if (given.has("--claim") || given.has("--group")) leave_out_other_notes(result);
  result.with_proofs = given.has("--proof");
  write_verify(common.format, result, output);
  if (page) write_report(result, processes, *page);
  output.commit();
  return exit_code_of(result.reports);
}

ExitCode report(const Given& given) {
  const checks::Context context = context_of(given, given.digits(50));
  const unsigned processes = processes_of(given);
  const std::string file = report_file(given.folder());
  Output page(file);
  const VerifyResult result = examine(context, processes, checks::registry());
  write_report(result, processes, page);
  write_whole(std::nullopt, fmt::format("{}: {}; {}\n", file, counts_line(result.reports), controls_line(result)));
  return exit_code_of(result.reports);
}

}  // namespace

Command verify_command() {
  using enum Option::Kind;
  return {
      "verify", std::string(embedded::help_verify),
      with_common(
          {{"--list", "", "List the claims, check nothing", flag},
           {"--claim", "GLOB", "Only claims whose id matches, * and ? being wildcards; repeatable", repeatable},
           {"--group", "NAME", "Only claims of one place in the paper, theorem-2; --list names them"},
           {"--proof", "", "Print the proofs, as trees", flag},
           {"--quick", "", "Fewer parameters", flag},
           seed_option(),
           jobs_option("Claims examined"),
           {"--report", "DIR", "Write the report on this run as well: DIR/report.html"},
           {"--export-coq", "DIR", "Write the statements decided exactly as lemmas of Coq, DIR/*.v; check nothing"}},
          "Digits to work with, 1 to 100; default 50", formats),
      verify};
}

Command report_command() {
  return {"report",
          std::string(embedded::help_report),
          {{"--quick", "", "Fewer parameters", Option::Kind::flag},
           seed_option(),
           jobs_option("Claims examined, and figures drawn,"),
           {"--digits", "N", "Digits to work with, 1 to 100; default 50"},
           folder_option()},
          report};
}

}  // namespace steadyslide::app
