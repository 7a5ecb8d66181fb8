#pragma once
// Solves the contact problem in the space of its own singular functions. The traction is the Riemann-Hilbert form of
// traction_representation.hpp for a contact set. Newton's method finds its free ends, polynomial and tilt. [Bal16,
// theorem 36, reconstructed]

#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::numeric {

/// In double the cost grows in proportion to the number of places where the profile changes its polynomial; in higher
/// precision it grows faster than the square.
inline constexpr std::size_t max_profile_breaks = 1'000'000;
inline constexpr std::size_t max_profile_breaks_in_digits = 200;
/// Returns why a profile has too many breaks; empty if it has not.
std::string too_many_profile_breaks(const ContactProblem& problem, Digits digits);

/// True if the slope of the profile decreases at more than 100 breaks. A gap may open at each, and then cells are
/// faster.
bool may_have_many_gaps(const ContactProblem& problem);

/// Solves a problem with any profile, any number of friction jumps and of contact components. `start` is the solution
/// of a neighbouring problem (for example, with another load); its contact set is tried first. Without it, or if it
/// does not lead to a solution, a coarse variational solution locates the contact. If a solution violates a condition,
/// failed_condition() returns it. `reason` is set for problems that the method does not cover: an elastic indenter
/// whose contact reaches an edge, a profile with more than max_profile_breaks places where pieces meet, or more than
/// max_friction_pieces values of friction.
template <Real R>
Attempt<R> riemann_hilbert(const ContactProblem& problem, const ContactSolution<R>* start = nullptr);

}  // namespace steadyslide::numeric
