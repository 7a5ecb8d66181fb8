#pragma once
// steadyslide exponents --derivation: how each exponent comes about, and the closed form where there is one.

#include "app/commands/options.hpp"
#include "app/terminal/failure.hpp"
#include "model/contact_problem.hpp"

namespace steadyslide::app {

/// As text, or as a LaTeX document.
ExitCode write_derivations(const CommonOptions& options, const ContactProblem& problem);

}  // namespace steadyslide::app
