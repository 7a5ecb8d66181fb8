#pragma once
// A profile with two wells on two coatings, in reduced data: one or two components of contact, a jump in one of them.

#include <optional>

#include "support/solved_contact.hpp"

namespace steadyslide::testing {

/// (x^2 - 1)^2 + slope x on [-3, 3].
inline Indenter two_wells(const Rational& slope = 0.2_r) { return one_piece(-3, 3, {1, slope, -2, 0, 1}); }

/// s = 3/10 left of x = 1/10 and 1 right of it.
inline ContactProblem on_two_coatings(const Indenter& indenter, const Rational& load,
                                      const std::optional<Rational>& load_at = std::nullopt) {
  return reduced({0.3_r, 1}, {0.1_r}, indenter, load, load_at);
}

}  // namespace steadyslide::testing
