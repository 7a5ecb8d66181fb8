#pragma once
// steadyslide table

#include "app/failure.hpp"
#include "app/options.hpp"

namespace steadyslide::app {

ExitCode run(const TableOptions& options);

}  // namespace steadyslide::app
