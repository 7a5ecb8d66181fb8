#pragma once
// steadyslide exponents

#include "app/commands/options.hpp"
#include "app/terminal/failure.hpp"

namespace steadyslide::app {

ExitCode run(const ExponentsOptions& options);

}  // namespace steadyslide::app
