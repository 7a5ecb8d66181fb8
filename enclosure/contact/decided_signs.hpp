#pragma once
// When a zero of the conditions is a solution: t <= 0 on the contact and a gap >= 0 beside it, decided for every place and
// for all values of the unknowns in a box.
//
//   on a segment in contact      eps B_k < 0 on the closed segment: t = eps cos(pi alpha) |Y| B_k. At its points this is the
//                                sign of the leading terms: of a power's amplitude, of D/[s], of a wedge's logarithm;
//   off the contact              gap' = psi' - u' = Y B_k; the gap is > 0 where it grows from the contact's end on, and
//                                elsewhere if a lower bound of its integral, from the contact on either side, is.
//
// B_k = R + C E(d) next to a point, d the distance from it (traction_representation.hpp): on [0, d_1] by the range of E, which may be
// unbounded, and outwards on intervals cut in geometric proportion, since E changes with log d.

#include <string>
#include <vector>

#include "enclosure/contact/traction_representation.hpp"
#include "enclosure/number/work_budget.hpp"

namespace steadyslide::enclosure {

struct SignsDecided {
  bool proved = true;
  /// A sign is decided the other way: more precision will not help.
  bool refuted = false;
  /// Of the first one that is not as it has to be, or not decided.
  std::string reason;
  Ball x;  ///< where, in xi
  std::size_t intervals = 0;
};

/// `form` over the box; its precision and its number of nodes are those of the decision. A gap is divided `most_rounds` times:
/// cells that are thin beside what the box's own width does to them decide nothing more. A sign that is open when the budget is
/// spent stays undecided.
SignsDecided decide_signs(const TractionRepresentation& form, WorkBudget& work, int most_rounds = 40);

}  // namespace steadyslide::enclosure
