#pragma once
// steadyslide figures

#include "app/failure.hpp"
#include "app/options.hpp"

namespace steadyslide::app {

ExitCode run(const FiguresOptions& options);

}  // namespace steadyslide::app
