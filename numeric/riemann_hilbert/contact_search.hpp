#pragma once
// Finds the contact set: Newton's method for the ends, then every inequality; where one fails, or where an end runs
// into a jump, an edge or another end, the set changes and Newton's method goes on.

#include <string>
#include <vector>

#include "numeric/riemann_hilbert/contact_newton.hpp"
#include "numeric/riemann_hilbert/local_signs.hpp"

namespace steadyslide::numeric {

template <Real R>
struct SearchResult {
  ContactState<R> state;
  StateErrors<R> errors;
  std::string failed_condition;  ///< empty: every condition holds
  std::vector<HairlineGap<R>> hairline_gaps = {};

  bool solved() const { return failed_condition.empty(); }
};

/// From a set that may be wrong in place and in kind.
template <Real R>
SearchResult<R> search_contact(const RoundedProblem<R>& problem, ContactState<R> start, JacobiRules<R>& rules);

}  // namespace steadyslide::numeric
