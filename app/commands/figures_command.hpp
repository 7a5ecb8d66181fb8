#pragma once
// steadyslide figures

#include "app/commands/options.hpp"
#include "app/terminal/failure.hpp"

namespace steadyslide::app {

ExitCode run(const FiguresOptions& options);

}  // namespace steadyslide::app
