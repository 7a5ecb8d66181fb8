#pragma once
// Compares estimated errors of forces on cells with their differences from the Riemann-Hilbert solution.
//
// An estimate is honest if the two numbers differ by no more than the sum of their estimates.

#include "known_limits/error_estimates.hpp"

namespace steadyslide::testing {

/// Solves problem number `seed` of random_contact.hpp on `cells` cells. Compares friction, load shares, the load of
/// each zone if both methods have the same number of zones, centre of pressure, and tilt. Skips problems that one of
/// the methods does not solve.
void audit_cell_estimates(std::uint64_t seed, std::size_t cells, EstimateAudit& audit);

/// Returns an empty text, or the fault: an estimate that is not honest; a median of more than thirty times the true
/// error of friction or of load shares; too few solutions to judge.
std::string cell_failure(const EstimateAudit& audit);

}  // namespace steadyslide::testing
