#pragma once
// Claims whose equations the symbolic layer derives and decides: its statements as evidence, each wrong variant that it
// has as a control of its own.

#include <string>
#include <vector>

#include "model/rational.hpp"
#include "proofs_checks/kit/claim.hpp"
#include "symbolic/field/exact_identity.hpp"

namespace steadyslide::proofs_checks {

/// Deciding takes seconds: it is done when a claim is first examined, and once.
using DecidedStatements = const std::vector<symbolic::DecidedStatement>& (*)();
const std::vector<symbolic::DecidedStatement>& decided_riemann_hilbert();
/// Of theorems 2, 3, 9 and 10.
const std::vector<symbolic::DecidedStatement>& decided_local_forms();

/// Names are known without deciding anything, and are compared with the symbolic layer's when the claim is examined.
/// The families are those that the claim's text lists.
Claim derived(std::string_view id, DecidedStatements source);

/// The claim, proved by the statements with these ids, as `argument` says; each of their wrong variants is a control
/// more. What the claim itself compares stands behind.
Claim proved_by(const std::vector<std::string>& ids, std::string argument, Claim claim);

}  // namespace steadyslide::proofs_checks
