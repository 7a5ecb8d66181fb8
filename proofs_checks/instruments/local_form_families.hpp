#pragma once
// The local forms of theorems 2, 3, 9 and 10 as the symbolic layer decides them, with their wrong variants.

#include "proofs_checks/instruments/derived.hpp"

namespace steadyslide::proofs_checks {

const std::vector<symbolic::DecidedStatement>& decided_local_forms();

/// Edges or free ends of a theorem, "theorem-3"; with two frictions, those on both sides can be taken for each other.
Family end_family(const std::string& theorem, bool free, bool two_frictions);
/// The logarithm at a wedge.
Family wedge_family(std::vector<std::string> ids);

}  // namespace steadyslide::proofs_checks
