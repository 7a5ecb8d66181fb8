#pragma once
// The decided statements of the symbolic layer, by their ids. Deciding them takes seconds: it is done at the first
// request, and once. Not thread-safe, because GiNaC is not.

#include <string>
#include <string_view>
#include <vector>

#include "symbolic/field/exact_identity.hpp"

namespace steadyslide::proofs_checks {

/// Returns the statements with these ids. An id that ends with a dash stands for all ids that begin with it. Throws
/// std::logic_error if an id has no statement.
std::vector<symbolic::DecidedStatement> decided_statements(const std::vector<std::string>& ids);

/// True if the divisor is not 0 for any real values of its symbols: a number, pi, i + s, s^2 + 1. Returns false for a
/// form that it does not recognise.
bool never_vanishes(std::string_view divisor);

}  // namespace steadyslide::proofs_checks
