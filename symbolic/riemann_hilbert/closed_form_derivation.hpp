#pragma once
// Derivations of the closed forms, for readers. This header does not include GiNaC. Not thread-safe, because GiNaC is
// not.

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

/// Returns the derivation with symbols for frictions, jumps, ends, load and profile. Steps that are statements are
/// decided exactly during the derivation.
Derivation closed_form_derivation(ClosedFormKind kind, int jumps);
/// Returns the derivation for the flat punch with `jumps` jumps.
Derivation closed_form_derivation(int jumps);

/// Returns the closed forms of the problem with its numbers, one for each contact that satisfies the equations. Throws
/// std::domain_error if the profile is none of the above (derived_contact.hpp).
std::vector<Derivation> riemann_hilbert_derivations(const ContactProblem& problem);

}  // namespace steadyslide::symbolic
