#pragma once
// A free end between two anchors can be seen from either: c_k + h = c_{k+1} - h', h' = c_{k+1} - c_k - h. Both say the same
// contact set; the nearer anchor says it with more digits, and the end is where it is as long as it lies between them.

#include <optional>

#include "enclosure/contact/krawczyk.hpp"

namespace steadyslide::enclosure {

/// Each free end seen from the nearer of the two anchors around it.
ContactBox seen_from_nearer(const ReducedProblem& problem, const ContactBox& box);

/// The free ends seen from the anchors of `other`; nothing where that is another contact set.
std::optional<ContactBox> seen_from(const ReducedProblem& problem, const ContactBox& box, const ContactTopology& other);

}  // namespace steadyslide::enclosure
