#pragma once
// What proofs of remark 1, of a published integral and of single contact problems decide in balls.

#include "proofs_checks/proof/enclosures.hpp"

namespace steadyslide::proofs_checks {

/// The fourth derivative of cos(pi alpha) ((1+2 alpha)/(1-2 alpha))^alpha in s = tan(pi alpha) is at most 4!/20.
Enclosure peak_of_parabola();
/// -pi sqrt(2)/3^{3/4} is in ]-1.949054259166748, -1.949054259166747[.
Enclosure galin_at_two();
/// Solutions of three contact problems, with every sign.
Enclosure contact_over_notch();
Enclosure contact_of_two_wells();
Enclosure contact_of_bowl();

}  // namespace steadyslide::proofs_checks
