#pragma once
// The start of a search for the contact: its zones and its tilt, roughly.

#include <vector>

#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "numeric/solution/contact_interval.hpp"

namespace steadyslide::numeric {

/// Zones are measured from `origin`, in the problem's unit of length.
struct ContactStart {
  Rational origin;
  std::vector<ContactInterval> zones;
  double tilt = 0;  ///< slope added to psi/c

  /// Returns a frame with its origin in the middle of the contact, in which the half-width is near 1.
  Frame frame() const;
  /// Returns the zones in xi.
  std::vector<ContactInterval> in(const Frame& frame) const;
};

/// Returns the zones of a coarse variational solution on about this number of cells.
ContactStart coarse_start(const ContactProblem& problem, int cells);
/// Returns the zones of any solution, from its places.
template <Real R>
ContactStart start_from(const ContactProblem& problem, const ContactSolution<R>& solution);
/// Returns the zones of a solution, from the lengths of its set; measured from an anchor if one is near.
template <Real R>
ContactStart start_again(const RiemannHilbertSolution<R>& solution);

}  // namespace steadyslide::numeric
