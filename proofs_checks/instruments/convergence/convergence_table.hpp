#pragma once
// The section "Convergence tables" of docs/cost.md: errors of the solver on cells, their rates, and the exponents read
// off the cells. Computed, not typed.

#include <string>

namespace steadyslide::proofs_checks {

/// Of all problems. `quick`: the rows up to 2^9 cells of the tables of ends and resultants, and nothing else.
std::string convergence_document(bool quick);

}  // namespace steadyslide::proofs_checks
