#pragma once
// The contact problem solved in the space of its own singular functions: the traction is the Riemann-Hilbert form of
// traction_representation.hpp for a contact set whose free ends, polynomial and tilt are found by Newton's method.
// [Bal16, theorem 36, reconstructed]

#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::numeric {

/// In double the cost grows like the number of places where the profile changes its polynomial, in more digits faster than
/// like its square.
inline constexpr std::size_t max_profile_breaks = 1'000'000;
inline constexpr std::size_t max_profile_breaks_in_digits = 200;
/// Empty, or why a profile has too many of them.
std::string too_many_profile_breaks(const ContactProblem& problem, Digits digits);

/// Does the slope of the profile fall at more than 100 breaks? A gap may open at each, and cells are faster then.
bool may_have_many_gaps(const ContactProblem& problem);

/// Any profile, any number of friction jumps and contact components. `start`: the solution of a neighbouring problem
/// (the same but for the load, say), whose contact set is tried first; without it, or where it leads nowhere, a coarse
/// variational solution says where the contact is. A solution that fails a condition says so by failed_condition();
/// `reason` is for problems outside the method: an elastic indenter whose contact reaches an edge, or a profile with
/// more than max_profile_breaks places where pieces meet, or more than max_friction_pieces values of friction.
template <Real R>
Attempt<R> riemann_hilbert(const ContactProblem& problem, const ContactSolution<R>* start = nullptr);

}  // namespace steadyslide::numeric
