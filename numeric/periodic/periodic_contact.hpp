#pragma once
// Finds the zone of contact in each period. Periodic contact has one solution at most (docs/theory.md, "Periodic
// contact"), so a state without tension and without penetration is the solution.

#include <string>
#include <variant>

#include "model/contact_problem.hpp"
#include "numeric/periodic/periodic_traction.hpp"

namespace steadyslide::numeric {

template <Real R>
struct PeriodicContact {
  Rational origin;  ///< of the traction's x, in the user's x
  PeriodicTraction<R> traction;
  std::vector<Complex<R>> g;  ///< A_n + i B_n
  bool left_is_free;
  bool right_is_free;
  std::vector<std::size_t> pieces;  ///< the friction piece on each arc of the contact
  std::vector<Rational> points;     ///< e_0, ..., e_n in the user's x; free ends as the nearest number
  R end_error;                      ///< estimated absolute error of free ends
};

/// Returns the contact, or the reason why none is found: the profile is neither flat nor a sum of harmonics, or the
/// contact has several zones in each period. `problem` has a period.
template <Real R>
std::variant<PeriodicContact<R>, std::string> periodic_contact(const ContactProblem& problem);

}  // namespace steadyslide::numeric
