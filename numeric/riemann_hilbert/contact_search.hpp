#pragma once
// Finds the contact set. Newton's method finds the ends, then every inequality is checked. If one fails, or if an end
// reaches a jump, an edge or another end, the set changes and Newton's method continues.

#include <string>
#include <vector>

#include "numeric/riemann_hilbert/contact_newton.hpp"
#include "numeric/riemann_hilbert/local_signs.hpp"

namespace steadyslide::numeric {

template <Real R>
struct SearchResult {
  ContactState<R> state;
  StateErrors<R> errors;
  std::string failed_condition;  ///< empty if every condition holds
  std::vector<HairlineGap<R>> hairline_gaps = {};

  bool solved() const { return failed_condition.empty(); }
};

/// Starts from a set whose ends may be at wrong places and of wrong kinds.
template <Real R>
SearchResult<R> search_contact(const RoundedProblem<R>& problem, ContactState<R> start, JacobiRules<R>& rules);

}  // namespace steadyslide::numeric
