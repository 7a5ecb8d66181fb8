#pragma once
// Derivations of the closed forms, for a reader. Without GiNaC in this header. Not thread-safe, as GiNaC is not.

#include <vector>

#include "model/contact_problem.hpp"
#include "symbolic/field/derivation.hpp"

namespace steadyslide::symbolic {

enum class ClosedFormKind {
  flat_punch,
  tilted_punch,
  lifted_punch,  ///< left edge, free right end
  parabola,
  parabola_left_edge,
  parabola_right_edge,
  parabola_two_edges,
  quartic
};

/// With symbols for frictions, jumps, ends, load and profile. Every step that is a decision is decided on the way.
Derivation closed_form_derivation(ClosedFormKind kind, int jumps);
/// The flat punch with `jumps` jumps.
Derivation closed_form_derivation(int jumps);

/// The problem's own closed forms, with its numbers: one for each contact that satisfies its equations. Throws
/// std::domain_error where the profile is none of the above (derived_contact.hpp).
std::vector<Derivation> riemann_hilbert_derivations(const ContactProblem& problem);

}  // namespace steadyslide::symbolic
