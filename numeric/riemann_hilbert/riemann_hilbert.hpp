#pragma once
// The contact problem solved in the space of its own singular functions: the traction is the Riemann-Hilbert form of
// riemann_hilbert_form.hpp for a contact set whose free ends, polynomial and tilt are found by Newton's method.
// [Bal16, theorem 36, reconstructed]

#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::numeric {

/// The cost grows faster than the square of the breaks: with 200 of them a polygon in a parabola takes about a second,
/// a rough one with tens of contact zones half a minute.
inline constexpr std::size_t max_profile_breaks = 200;

/// Any profile, any number of friction jumps and contact components. `start`: the solution of a neighbouring problem
/// (the same but for the load, say), whose contact set is tried first; without it, or where it leads nowhere, a coarse
/// variational solution says where the contact is. A solution that fails a condition says so by failed_condition();
/// `reason` is for problems outside the method: an elastic indenter whose contact reaches an edge, or a profile with
/// more than max_profile_breaks places where pieces meet, or more than max_friction_pieces values of friction.
template <Real R>
Attempt<R> riemann_hilbert(const ContactProblem& problem, const ContactSolution<R>* start = nullptr);

}  // namespace steadyslide::numeric
