#pragma once
// Claims whose equations the symbolic layer derives and decides. Each wrong variant that it has is a control of its
// own.

#include <string>
#include <vector>

#include "proofs_checks/kit/claim.hpp"
#include "symbolic/statements/exact_identities.hpp"

namespace steadyslide::proofs_checks {

/// Statements that share their wrong variants.
struct Family {
  std::string about;                  ///< opens the names of the controls
  std::vector<std::string> ids;       ///< of the statements; what ends with "-" is the beginning of several
  std::vector<std::string> variants;  ///< what is wrong, in the words of the symbolic layer: all that it has
};

/// Deciding takes seconds: it is done when a claim is first examined, and once.
using DecidedStatements = const std::vector<symbolic::DecidedStatement>& (*)();
const std::vector<symbolic::DecidedStatement>& decided_riemann_hilbert();

/// Names are known without deciding anything, and are compared with the symbolic layer's when the claim is examined.
Claim derived(std::string_view id, DecidedStatements source, const std::vector<Family>& families);

}  // namespace steadyslide::proofs_checks
