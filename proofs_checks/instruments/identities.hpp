#pragma once
// What the claims about constants share: the statements that the symbolic layer has decided, as evidence.

#include <string>
#include <vector>

#include "model/rational.hpp"
#include "proofs_checks/kit/claim.hpp"
#include "symbolic/statements/exact_identities.hpp"

namespace steadyslide::proofs_checks {

/// Far below every tolerance of the ledger, and still visible to exact arithmetic.
Rational tiny();

/// The statements' own identities, without their controls.
std::vector<symbolic::ExactIdentity> right_identities(const std::vector<symbolic::DecidedStatement>& chosen);

/// A counterexample among the identities, or all of them as one piece of evidence that covers the claim.
Evidence weigh_identities(const std::vector<symbolic::ExactIdentity>& identities, std::string detail);

/// The claim, proved by the statements with these ids, as `argument` says; each of their wrong variants is a control
/// more. What the claim itself compares stands behind.
Claim proved_by(const std::vector<std::string>& ids, std::string argument, Claim claim);

}  // namespace steadyslide::proofs_checks
