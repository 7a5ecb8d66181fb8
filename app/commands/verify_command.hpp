#pragma once
// steadyslide verify

#include <span>

#include "app/commands/options.hpp"
#include "app/terminal/failure.hpp"
#include "proofs_checks/kit/run.hpp"

namespace steadyslide::app {

ExitCode run(const VerifyOptions& options);

struct VerifyResult;

/// Runs the claims, with progress on stderr where that is a terminal. Throws Failure for a pattern that names no claim.
VerifyResult examine(const VerifyOptions& options);

/// Done only if nothing is refuted, and nothing undecided but what is beyond calculation.
ExitCode exit_code_of(std::span<const proofs_checks::Report> reports);

}  // namespace steadyslide::app
