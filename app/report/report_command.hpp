#pragma once
// steadyslide report

#include "app/failure.hpp"
#include "app/options.hpp"

namespace steadyslide::app {

ExitCode run(const ReportOptions& options);

}  // namespace steadyslide::app
