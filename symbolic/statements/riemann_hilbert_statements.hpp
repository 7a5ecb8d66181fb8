#pragma once
// What sliding contact's Riemann-Hilbert problem says, as exact statements that are decided, each with wrong variants
// that the same decision refutes. Without GiNaC in this header. Not thread-safe, as GiNaC is not.

#include "symbolic/statements/exact_identities.hpp"

namespace steadyslide::symbolic {

/// The relation between Phi+ and Phi-, the exponents, Y+ = G Y-, the integer they sum to, the general solution, the
/// count of unknowns; polynomial profiles; the flat punch, flat or tilted, with any number of jumps [Bal16, (4),
/// (5)-(7), (8)]; the inverse of the operator [Bal16, (10)]; the parabola [Bal16, section 2] with any number of jumps,
/// free or against an edge; the quartic.
std::vector<DecidedStatement> riemann_hilbert_statements();

}  // namespace steadyslide::symbolic
