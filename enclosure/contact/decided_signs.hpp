#pragma once
// Decides if a zero of the conditions is a solution: t <= 0 on the contact and a gap >= 0 outside, for every place and
// for all values of the unknowns in a box.
//
//   on a segment in contact      eps B_k < 0 on the closed segment: t = eps cos(pi alpha) |Y| B_k. At its points this is
//                                the sign of the leading terms: of a power's amplitude, of D/[s], of a wedge's logarithm;
//   outside the contact          gap' = psi' - u' = Y B_k. The gap is > 0 where it only grows from the end of contact.
//                                Elsewhere it is > 0 if a lower bound of its integral, from either end of contact, is > 0.
//
// B_k = R + C E(d) next to a point, d the distance from it (traction_representation.hpp): on [0, d_1] by the range of
// E, which may be unbounded, and outwards on intervals in geometric proportion, because E changes with log d.

#include <string>
#include <vector>

#include "enclosure/contact/traction_representation.hpp"
#include "enclosure/number/work_budget.hpp"

namespace steadyslide::enclosure {

struct SignsDecided {
  bool proved = true;
  /// True if a sign is decided the other way. Then more precision does not help.
  bool refuted = false;
  /// The reason for the first sign that is wrong or undecided.
  std::string reason;
  Ball x;  ///< its place in xi
  std::size_t intervals = 0;
};

/// Decides the signs of `form` over the box, with its precision and number of nodes. A gap is divided at most
/// `most_rounds` times, because cells that are thin compared with the effect of the box's width decide nothing more. A
/// sign that is open when the budget is spent stays undecided.
SignsDecided decide_signs(const TractionRepresentation& form, WorkBudget& work, int most_rounds = 40);

}  // namespace steadyslide::enclosure
