#pragma once
// steadyslide verify

#include "app/failure.hpp"
#include "app/options.hpp"
#include "proofs_checks/run.hpp"

namespace steadyslide::app {

ExitCode run(const VerifyOptions& options);

/// Done only if nothing is refuted and nothing undecided.
ExitCode exit_code_of(const proofs_checks::Counts& counts);

}  // namespace steadyslide::app
