#pragma once
// steadyslide verify

#include "app/failure.hpp"
#include "app/options.hpp"

namespace steadyslide::app {

ExitCode run(const VerifyOptions& options);

}  // namespace steadyslide::app
