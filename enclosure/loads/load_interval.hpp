#pragma once
// A contact set proved for every load of an interval. With w the first-order change of the conditions' zero from the middle
// load to the ends of the interval,
//
//   V = the box of half-widths |w| around the zero at the middle load, widened until K(V) lies inside it for all these
//   loads at once (krawczyk.hpp),
//
// so that each of the loads has exactly one zero in V, and the signs are decided over K(V), which holds all these zeros:
// the contact has this topology throughout, and its ends move continuously. (The zero is unique in V for each load, F is
// continuous, V is compact.)
//
// V is about |dv/dload| (to - from) wide, whatever the precision: near an event, where the logarithm of an end's offset or
// the length of a gap or a zone changes with the distance from the event's load, intervals are as short as that distance.

#include "enclosure/contact/contact_proof.hpp"

namespace steadyslide::enclosure {

/// What is as wide as an interval needs no more.
inline constexpr Bits load_interval_bits = 64;

struct LoadInterval {
  Rational from;  ///< loads in the user's unit, from the smaller to the larger
  Rational to;
  ContactBox at_from;  ///< if proved, the zero at either end, to second order in the interval's length
  ContactBox at_to;
  ContactBox box;      ///< V: prove_box(proof.problem, box, proof.bits) holds as it stands
  ContactProof proof;  ///< of all these loads; its box is K(V)
};

/// `guess`: near the zero at the middle load. Throws InvalidData unless 0 < from <= to.
LoadInterval prove_loads(const ReducedProblem& problem, const Rational& from, const Rational& to,
                         const ContactBox& guess, JacobiRules& rules, WorkBudget& work);

/// From what a solver found at some load nearby, with a budget of its own.
LoadInterval prove_loads(const ContactProblem& problem, const ApproximateContact& contact, const Rational& from,
                         const Rational& to, Bits bits = load_interval_bits);

/// Of two proved intervals, the second beginning where the first one ends: is the zero at that load, exactly one in either
/// box, the same? Then both are one branch of solutions.
bool are_joined(const LoadInterval& left, const LoadInterval& right, JacobiRules& rules, WorkBudget& work);

}  // namespace steadyslide::enclosure
