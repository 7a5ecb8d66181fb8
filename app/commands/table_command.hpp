#pragma once
// steadyslide table

#include "app/commands/options.hpp"
#include "app/terminal/failure.hpp"

namespace steadyslide::app {

ExitCode run(const TableOptions& options);

}  // namespace steadyslide::app
