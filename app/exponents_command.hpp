#pragma once
// steadyslide exponents

#include "app/failure.hpp"
#include "app/options.hpp"

namespace steadyslide::app {

ExitCode run(const ExponentsOptions& options);

}  // namespace steadyslide::app
