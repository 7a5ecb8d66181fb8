#pragma once
// steadyslide report

#include "app/commands/options.hpp"
#include "app/results/verify_writers.hpp"
#include "app/terminal/failure.hpp"
#include "app/terminal/output.hpp"

namespace steadyslide::app {

ExitCode run(const ReportOptions& options);

/// FOLDER/report.html; the folder is made if need be. Throws Failure with exit code 3.
std::string report_file(const std::string& folder);

/// The page with figures, tables and mutants, to a file that was opened before the run. Without gnuplot it says that
/// there are no figures.
void write_report(const VerifyResult& result, Output& output);

}  // namespace steadyslide::app
