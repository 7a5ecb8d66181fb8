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
  R end_error;                           ///< estimated absolute error of the free ends, in xi
  std::string failed_condition;          ///< empty: every condition holds
  R tilt_error = 0;                      ///< of the tilt, in units of c
  R length_error = 1;                    ///< relative, of lengths that count by their order of magnitude
  std::vector<R> polynomial_error = {};  ///< StateErrors::polynomial
  std::vector<HairlineGap<R>> hairline_gaps = {};

  StateErrors<R> errors() const { return {{end_error, R(1), length_error}, polynomial_error}; }
  bool solved() const { return failed_condition.empty(); }
};

/// From a set that may be wrong in place and in kind.
template <Real R>
SearchResult<R> search_contact(const ReducedProblem<R>& problem, ContactState<R> start, JacobiRules<R>& rules);

}  // namespace steadyslide::numeric
