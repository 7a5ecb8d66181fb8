#pragma once
// Compares estimated errors of forces on cells with their differences from the Riemann-Hilbert solution.
//
// An estimate is honest if the two numbers differ by no more than the sum of their estimates.

#include "known_limits/error_estimates.hpp"

namespace steadyslide::testing {

/// Problem number `seed` of random_contact.hpp on so many cells: friction, load shares, load of each zone where both see as
/// many of them, centre of pressure, tilt. Problems that a method does not solve are left out.
void audit_cell_estimates(std::uint64_t seed, std::size_t cells, EstimateAudit& audit);

/// Empty, or what is wrong: an estimate that is not honest, a median of more than thirty times the true error of friction or of
/// load shares, or too few solutions to say so.
std::string cell_failure(const EstimateAudit& audit);

}  // namespace steadyslide::testing
