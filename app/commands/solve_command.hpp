#pragma once
// steadyslide solve

#include "app/commands/options.hpp"
#include "app/terminal/failure.hpp"

namespace steadyslide::app {

ExitCode run(const SolveOptions& options);

}  // namespace steadyslide::app
