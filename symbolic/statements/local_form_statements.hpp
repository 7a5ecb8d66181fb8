#pragma once
// The local forms of the paper's theorems, each put into the local equation and decided, with wrong variants that the
// same procedure refutes. Without GiNaC in this header. Not thread-safe, as GiNaC is not. [Bal16, theorems 2, 3, 9, 10]

#include <vector>

#include "symbolic/statements/exact_identities.hpp"

namespace steadyslide::symbolic {

/// Theorem 2 with a friction jump, with a wedge and a jump, with a wedge alone; theorem 3 at either end of contact, at
/// a step and free, with the slopes outside; theorem 9, and to all three orders; theorem 10 as theorem 3 under one
/// friction. Both sides of an identity list the coefficients of the local equation.
std::vector<DecidedStatement> local_form_statements();

}  // namespace steadyslide::symbolic
