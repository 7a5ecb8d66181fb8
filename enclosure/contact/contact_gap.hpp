#pragma once
// The gap between the surfaces at a place off the contact, enclosed, in units of c xi:
//
//   gap/c = steps of the profile + int (psi' - u')/c dxi   from the nearer end of contact to the place.
//
// int (psi' - u')/c = int (g - g_k) + Y B_k with k the slope of the contact at that end, with which B_k is analytic up to it.

#include "enclosure/contact/traction_representation.hpp"

namespace steadyslide::enclosure {

/// At a place in a segment off the contact, which is thin. Not finite where there is no contact on either side.
Ball contact_gap(const TractionRepresentation& form, const Place& place);

}  // namespace steadyslide::enclosure
