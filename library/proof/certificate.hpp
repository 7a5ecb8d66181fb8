#pragma once
// The certificate of a proved solution: all that is needed to prove it again (docs/certificate.md).

#include <string>

#include "enclosure/cells/cell_bound.hpp"
#include "enclosure/loads/load_interval.hpp"

namespace steadyslide::library {

/// JSON. `proof` is one: proved, to so many digits.
std::string certificate(const ContactProblem& problem, const enclosure::ContactProof& proof, int digits);

/// Of a bound for pressures on cells, proved.
std::string certificate(const ContactProblem& problem, const enclosure::CellBound& bound);

/// Of a solution for all loads of intervals that follow each other.
std::string certificate(const ContactProblem& problem, const std::vector<enclosure::LoadInterval>& intervals);

}  // namespace steadyslide::library
