#pragma once
// Contact that repeats, for methods that solve one period on a line and see an end wherever it is cut. The cut has to lie
// in a gap. So such a method solves the same contact from another beginning of the period, and the solution is given back
// in the terms of the problem. Contact components lie within one period from that beginning.

#include <memory>
#include <utility>
#include <vector>

#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::numeric {

/// Returns x moved by whole periods into [left, left + period[.
Rational moved_into(const Rational& x, const Rational& left, const Rational& period);

/// True if the indenter has no edges: its support is as long as the period.
bool is_without_edges(const ContactProblem& problem);

/// Returns the beginning of a period whose ends lie in a gap, at most half a period from the support's left end, from
/// the ends of the zones, left to right. It is the support's left end if that lies in a wide gap, if there is no gap, or
/// if the support is shorter than the period or nothing repeats.
Rational beginning_in_gap(const ContactProblem& problem, const std::vector<std::pair<double, double>>& zones);

/// Returns the problem with the same contact whose support begins at this place.
ContactProblem beginning_at(const Rational& begin, const ContactProblem& problem);

/// Returns a solution of beginning_at(begin, problem) as one of the problem, with fields that repeat. Returns `solution`
/// itself if nothing repeats.
std::shared_ptr<const ContactSolution<double>> repeated(const ContactProblem& problem, const Rational& begin,
                                                        std::shared_ptr<const ContactSolution<double>> solution);

}  // namespace steadyslide::numeric
