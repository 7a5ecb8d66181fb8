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

/// The sentence on problems with a period that have no certificate.
inline constexpr const char* no_periodic_certificate =
    "with a period there are certificates for flat punches that do not tilt and for harmonics with one zone of contact";

struct PeriodicCertificate {
  std::string text;    ///< empty: there is none
  std::string reason;  ///< the reason if there is none
};

inline constexpr int most_periodic_digits = 80;

/// The certificate of periodic contact: the numbers of the closed form in a box, with at most 80 digits. Nothing is
/// proved; steadyslide-check proves it.
PeriodicCertificate periodic_certificate(const ContactProblem& problem, int digits);

/// The certificate of solutions for all loads of consecutive intervals.
std::string certificate(const ContactProblem& problem, const std::vector<enclosure::LoadInterval>& intervals);

}  // namespace steadyslide::library
