#pragma once
// The tables of docs/convergence.md, in Markdown: errors of the solver on cells, their rates, and the exponents read
// off the cells. Computed, not typed.

#include <string>

namespace steadyslide::proofs_checks {

/// Of all problems. Quick: only what a quick run computes and the full one computes the same way, the rows of the ends
/// and the resultants up to 2^10 cells.
std::string convergence_document(bool quick);

}  // namespace steadyslide::proofs_checks
