#pragma once
// The result of the Riemann-Hilbert solver, from which a proof starts.

#include "enclosure/contact/contact_proof.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"

namespace steadyslide::testing {

/// Returns nothing if the solver does not converge.
template <class R>
std::optional<ApproximateContact> found_contact(const ContactProblem& problem) {
  const auto solution = numeric::riemann_hilbert<R>(problem).solution;
  if (!solution || !solution->failed_condition().empty()) return std::nullopt;
  return solution->approximate_contact();
}

}  // namespace steadyslide::testing
