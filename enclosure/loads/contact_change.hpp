#pragma once
// Describes the change between two contact sets of one problem with neighbouring loads. Zones of both sets are matched
// by their places; the topologies give the change of a zone.

#include <string>

#include "enclosure/contact/krawczyk.hpp"

namespace steadyslide::enclosure {

/// Returns text such as "the right end of contact passes the friction jump at x = 0.2" or "two zones of contact meet
/// near x = 0.31"; several changes are joined by " and ". Places are in the user's x: exact for places of the data,
/// otherwise with four digits.
std::string contact_change(const ReducedProblem& problem, const ContactBox& before, const ContactBox& after);

}  // namespace steadyslide::enclosure
