#pragma once

#include "app/commands/command_line.hpp"
#include "app/sweep/sweep.hpp"

namespace steadyslide::app {

struct SweepOptions {
  SweepWanted wanted;
  bool hdf5;
};

/// Throws Failure. Without --jobs there is one thread for each core.
SweepOptions read_sweep_options(const Given& given);

/// The command `sweep`, for any program that has it.
Command sweep_command(ExitCode (*run)(const Given& given));

}  // namespace steadyslide::app
