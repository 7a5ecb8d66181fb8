#include "app/report/report_command.hpp"

namespace steadyslide::app {

ExitCode run(const ReportOptions& /*options*/) { throw bad_command_line("report: not available in this version"); }

}  // namespace steadyslide::app
