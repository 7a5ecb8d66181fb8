#include "app/commands/report_command.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/commands/verify_command.hpp"
#include "app/report/embedded.hpp"
#include "app/report/ledger_section.hpp"
#include "app/report/report_page.hpp"

namespace steadyslide::app {
namespace {

Supplement supplement() {
  Supplement parts;
  try {
    parts.figures = draw_figures({});
  } catch (const Failure& failure) {
    if (failure.code() == ExitCode::interrupted) throw;
    parts.no_figures = fmt::format("No figures: {}.", failure.what());
  }
  parts.tables = exponent_tables();
  parts.mutants = read_mutants(embedded::mutants_csv);
  return parts;
}

}  // namespace

std::string report_file(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Failure(ExitCode::failed, fmt::format("{}: cannot be made: {}", folder, error.message()));
  return (std::filesystem::path(folder) / "report.html").string();
}

void write_report(const VerifyResult& result, Output& output) {
  output.write(report_html(result, supplement()));
  output.commit();
}

ExitCode run(const ReportOptions& options) {
  const std::string file = report_file(options.folder);
  Output page(file);
  const VerifyResult result = examine(options.verify);
  write_report(result, page);
  Output line(std::nullopt);
  line.write(fmt::format("{}: {}; {}\n", file, counts_line(result), controls_line(result)));
  line.commit();
  return exit_code_of(result.reports);
}

}  // namespace steadyslide::app
