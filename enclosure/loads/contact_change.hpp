#pragma once
// What happens between two contact sets of one problem whose loads are next to each other, in words: which zone of one is
// which of the other is decided by where they lie, what happens to it by the topologies.

#include <string>

#include "enclosure/contact/krawczyk.hpp"

namespace steadyslide::enclosure {

/// "the right end of contact passes the friction jump at x = 0.2", "two zones of contact meet near x = 0.31"; several changes
/// with " and " between them. Places in the user's x: exact where they are places of the data, else to four digits.
std::string contact_change(const ReducedProblem& problem, const ContactBox& before, const ContactBox& after);

}  // namespace steadyslide::enclosure
