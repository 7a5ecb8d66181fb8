#pragma once
// The symbolic layer's decided statements, by their ids. Deciding takes seconds: it is done when one is first asked for, and
// once. Not thread-safe, as GiNaC is not.

#include <string>
#include <string_view>
#include <vector>

#include "symbolic/field/exact_identity.hpp"

namespace steadyslide::proofs_checks {

/// Those with these ids; one that ends in a dash names all that begin like it. Throws std::logic_error if one is missing.
std::vector<symbolic::DecidedStatement> decided_statements(const std::vector<std::string>& ids);

/// Is a divisor never 0, whatever real numbers its symbols are: a number, pi, i + s, s^2 + 1? False where that is not seen.
bool never_vanishes(std::string_view divisor);

}  // namespace steadyslide::proofs_checks
