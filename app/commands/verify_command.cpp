#include "app/commands/verify_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "app/commands/report_command.hpp"
#include "app/results/verify_writers.hpp"
#include "proofs_checks/kit/registry.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;

void check_patterns(const std::vector<std::string>& patterns) {
  for (const std::string& pattern : patterns) {
    const auto matches = [&](const checks::Claim& claim) { return checks::matches_glob(claim.id, pattern); };
    if (std::ranges::any_of(checks::registry(), matches)) continue;
    throw bad_command_line("--claim: no such claim", "verify --list names them", pattern);
  }
}

std::vector<checks::Claim> selected(const VerifyOptions& options) {
  check_patterns(options.claims);
  std::vector<checks::Claim> claims = checks::select(checks::registry(), options.claims);
  if (options.group.empty()) return claims;
  const std::vector<std::string> groups = checks::groups();
  if (std::ranges::find(groups, options.group) == groups.end()) {
    throw bad_command_line("--group: no such place in the paper",
                           "one of " + fmt::format("{}", fmt::join(groups, ", ")), options.group);
  }
  std::erase_if(claims, [&](const checks::Claim& claim) { return claim.group != options.group; });
  return claims;
}

/// On a terminal only: a line that the next one overwrites.
void show_progress(const std::string& line) { fmt::print(stderr, "\r\x1b[K{}", line); }

}  // namespace

VerifyResult examine(const VerifyOptions& options) {
  const std::vector<checks::Claim> claims = selected(options);
  VerifyResult result;
  result.context.digits = numeric::precision_for(options.common.digits);
  result.context.seed = options.seed.value_or(result.context.seed);
  result.context.quick = options.quick;
  const bool on_terminal = ::isatty(STDERR_FILENO) == 1;
  result.reports =
      checks::run_all(claims, result.context, [&](std::size_t index, std::size_t total, const checks::Claim& claim) {
        if (on_terminal) {
          show_progress(fmt::format("[{}/{}] {}", index + 1, total, claim.id));
        }
        return true;
      });
  if (on_terminal) show_progress("");
  result.notes = checks::reading_notes(result.reports);
  if (!options.claims.empty() || !options.group.empty()) leave_out_other_notes(result);
  return result;
}

ExitCode run(const VerifyOptions& options) {
  const std::vector<checks::Claim> claims = selected(options);
  // Opened first: a run may be long, and should not end in a folder that does not exist.
  Output output(options.common.output);
  if (options.list) {
    write_claims(options.common.format, claims, output);
    output.commit();
    return ExitCode::done;
  }
  std::optional<Output> page;
  if (options.report) page.emplace(report_file(*options.report));
  const VerifyResult result = examine(options);
  write_verify(options.common.format, result, output);
  if (page) write_report(result, *page);
  output.commit();
  return exit_code_of(result.reports);
}

void leave_out_other_notes(VerifyResult& result) {
  const auto is_other = [&](const checks::ReadingNote& note) {
    return std::ranges::none_of(result.reports, [&](const checks::Report& r) { return r.claim.id == note.claim; });
  };
  result.notes_left_out += std::erase_if(result.notes, is_other);
}

ExitCode exit_code_of(std::span<const checks::Report> reports) {
  return checks::settled(reports) ? ExitCode::done : ExitCode::refuted;
}

}  // namespace steadyslide::app
