#pragma once
// Proves a contact set for every load of an interval. Let w be the first-order change of the conditions' zero from the
// middle load to the ends of the interval, and
//
//   V = the box of half-widths |w| around the zero at the middle load, widened until K(V) lies inside it for all these
//   loads together (krawczyk.hpp).
//
// Then each load has exactly one zero in V. The signs are decided over K(V), which contains all these zeros. So the
// contact has this topology for all these loads, and its ends move continuously. (For each load the zero in V is
// unique, F is continuous, V is compact.)
//
// V has a width of about |dv/dload| (to - from), for any precision. Near an event, the logarithm of an end's offset or
// the length of a gap or a zone changes with the distance from the event's load; there intervals are as short as that
// distance.

#include "enclosure/contact/contact_proof.hpp"

namespace steadyslide::enclosure {

/// The precision; it is sufficient for boxes as wide as the box of an interval.
inline constexpr Bits load_interval_bits = 64;

struct LoadInterval {
  Rational from;  ///< loads in the user's unit, from the smaller to the larger
  Rational to;
  ContactBox at_from;  ///< if proved: the zeros at both ends, to second order in the interval's length
  ContactBox at_to;
  ContactBox box;      ///< V; prove_box(proof.problem, box, proof.bits) proves it again
  ContactProof proof;  ///< for all these loads; its box is K(V)
};

/// Proves an interval of loads. `guess` is near the zero at the middle load. Throws InvalidData unless 0 < from <= to.
LoadInterval prove_loads(const ReducedProblem& problem, const Rational& from, const Rational& to,
                         const ContactBox& guess, JacobiRules& rules, WorkBudget& work);

/// The same, starting from a solver's result at a load nearby, with its own budget.
LoadInterval prove_loads(const ContactProblem& problem, const ApproximateContact& contact, const Rational& from,
                         const Rational& to, Bits bits = load_interval_bits);

/// Takes two proved intervals, where the second one begins at the last load of the first one. Returns true if the zeros
/// of both boxes at this load are the same. Then both intervals are one branch of solutions.
bool are_joined(const LoadInterval& left, const LoadInterval& right, JacobiRules& rules, WorkBudget& work);

}  // namespace steadyslide::enclosure
