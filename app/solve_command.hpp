#pragma once
// steadyslide solve

#include "app/failure.hpp"
#include "app/options.hpp"

namespace steadyslide::app {

ExitCode run(const SolveOptions& options);

}  // namespace steadyslide::app
