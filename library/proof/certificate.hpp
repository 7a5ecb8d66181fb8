#pragma once
// The certificate of a proved solution: all data that a checker needs to prove it again (docs/certified.md).

#include <string>

#include "enclosure/cells/cell_bound.hpp"
#include "enclosure/loads/load_interval.hpp"

namespace steadyslide::library {

/// Returns the certificate as JSON. `proof` has to be proved, to `digits` digits.
std::string certificate(const ContactProblem& problem, const enclosure::ContactProof& proof, int digits);

/// The certificate of a proved error bound for pressures on cells.
std::string certificate(const ContactProblem& problem, const enclosure::CellBound& bound);

/// The certificate of solutions for all loads of consecutive intervals.
std::string certificate(const ContactProblem& problem, const std::vector<enclosure::LoadInterval>& intervals);

}  // namespace steadyslide::library
