#pragma once
// Computes the section "Convergence tables" of docs/cost.md: errors of the cell solver, their rates, and the exponents
// fitted to the cells.

#include <string>

namespace steadyslide::proofs_checks {

/// Returns the tables of all problems. `quick` gives only the tables of ends and resultants, with the rows up to 2^9
/// cells.
std::string convergence_document(bool quick);

}  // namespace steadyslide::proofs_checks
