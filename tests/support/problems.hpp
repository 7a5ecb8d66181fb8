#pragma once
// Short forms for contact problems in reduced data.

#include "model/contact_problem.hpp"
#include "support/test.hpp"

namespace steadyslide::testing {

/// c = 1, and s itself is the datum: gamma = 1/2 and f = 2 s.
inline ContactProblem reduced(std::vector<Rational> s, const std::vector<Rational>& jumps, const Indenter& indenter,
                              const Rational& load, const std::optional<Rational>& load_at = std::nullopt,
                              Sliding sliding = Sliding::plus_x) {
  for (Rational& value : s) value *= 2;
  return {Elasticity::reduced(0.5_r), FrictionProfile(std::move(s), jumps), indenter, load, sliding, load_at};
}

inline Indenter one_piece(const Rational& left, const Rational& right, const std::vector<Rational>& coefficients) {
  return {left, {{right, Polynomial(coefficients)}}};
}

/// Two slopes that meet at 0, on [-1, 1]: a wedge, or a notch.
inline Indenter roof(const Rational& left, const Rational& right, const Rational& bend = 0) {
  return {-1, {{0, Polynomial({0, left, bend})}, {1, Polynomial({0, right, bend})}}};
}

/// (x^2 - 1)^2 + slope x on [-3, 3].
inline Indenter two_wells(const Rational& slope = 0.2_r) { return one_piece(-3, 3, {1, slope, -2, 0, 1}); }

/// s = 3/10 left of x = 1/10 and 1 right of it: two wells have one or two components of contact there, and a jump in
/// one.
inline ContactProblem on_two_coatings(const Indenter& indenter, const Rational& load,
                                      const std::optional<Rational>& load_at = std::nullopt) {
  return reduced({0.3_r, 1}, {0.1_r}, indenter, load, load_at);
}

}  // namespace steadyslide::testing
