#pragma once
// A free end between two anchors can be expressed by each of them: c_k + h = c_{k+1} - h', h' = c_{k+1} - c_k - h. Both
// describe the same contact set, as long as the end lies between the anchors. The nearer anchor gives more digits.

#include <optional>

#include "enclosure/contact/krawczyk.hpp"

namespace steadyslide::enclosure {

/// Returns the box with each free end expressed by the nearer of the two anchors around it.
ContactBox with_nearest_anchors(const ReducedProblem& problem, const ContactBox& box);

/// Returns the box with the free ends expressed by the anchors of `other`; absent if `other` is another contact set.
std::optional<ContactBox> with_anchors_of(const ReducedProblem& problem, const ContactBox& box,
                                          const ContactTopology& other);

}  // namespace steadyslide::enclosure
