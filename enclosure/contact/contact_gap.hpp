#pragma once
// The gap between the surfaces at a place off the contact, enclosed, in units of c xi:
//
//   gap/c = steps of the profile + int (psi' - u')/c dxi   from the nearer end of contact to the place.
//
// int (psi' - u')/c = int (g - g_k) + Y B_k with k the slope of the contact at that end, with which B_k is analytic up to it.

#include "enclosure/contact/traction_representation.hpp"

namespace steadyslide::enclosure {

class ContactGap {
 public:
  /// `form` has to outlive it.
  explicit ContactGap(const TractionRepresentation& form) : form_(form), set_(form.set()) {}

  /// At a place in a segment off the contact, which is thin. Not finite where there is no contact on either side.
  Ball at(const Place& place) const;

 private:
  /// Over parts of segments off the contact, from left to right.
  Ball change(const std::vector<ContactPanel::Part>& parts, std::size_t k) const;
  /// The profile's step at a point, from left to right.
  Ball step(std::size_t j) const;

  const TractionRepresentation& form_;
  const ContactSet& set_;
};

}  // namespace steadyslide::enclosure
