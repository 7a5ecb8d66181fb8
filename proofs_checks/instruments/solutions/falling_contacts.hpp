#pragma once
// Random contacts under friction that falls strongly, and changes of their data.

#include "model/contact_problem.hpp"
#include "proofs_checks/kit/random.hpp"

namespace steadyslide::proofs_checks {

/// Returns the problem with a polynomial added to every piece of the profile.
ContactProblem with_profile_plus(const ContactProblem& problem, const Polynomial& polynomial);
/// Returns the problem with an indenter that may tilt, or may not.
ContactProblem with_load_at(const ContactProblem& problem, std::optional<Rational> load_at);
/// Returns c P over the length of the support, the usual size of a slope.
Rational usual_slope(const ContactProblem& problem);

/// Returns a problem on [-1, 1] with 0 <= |s| <= 5 and one to three jumps, at which s mostly falls. The profile is, by
/// the remainder of k by 5: a quartic with one to three wells, a wedge, a wedge beside a notch, a parabola with a step,
/// two bumps.
ContactProblem random_falling_contact(Random& random, std::size_t k);

/// Returns two bumps that may tilt, with the load close to the right one. The left one loses contact as the load grows.
ContactProblem tilting_bumps();

}  // namespace steadyslide::proofs_checks
