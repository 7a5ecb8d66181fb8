#pragma once
// The derived tractions to any number of digits, in CLN. This code contains no closed form. The exponents come from the
// operator, epsilon is decided on the panels, N = Q + q and the conditions for the ends come from the series at
// infinity (riemann_hilbert.hpp, polynomial_slope.hpp). These expressions are evaluated:
//
//   t(x) = epsilon cos(pi alpha(x)) prod |x - e_j|^{p_j} N(x).
//
// For one contact under one profile psi = A x^2 + B x + C, A >= 0: flat, tilted or a parabola, each end an edge of the
// support or free, any number of friction jumps. The user's units and the user's x. Not thread-safe, because GiNaC is
// not.

#include <memory>
#include <vector>

#include "model/contact_problem.hpp"
#include "model/singular_point.hpp"
#include "symbolic/cln/decimal.hpp"
#include "symbolic/field/derivation.hpp"

namespace steadyslide::symbolic {

class DerivedContact {
 public:
  /// Returns every contact whose ends lie inside the support and satisfy their conditions, and whose traction is
  /// nowhere positive. Newton's method finds the ends. Throws std::domain_error unless the profile is as above, the
  /// indenter cannot tilt, and digits >= 1.
  static std::vector<DerivedContact> all(const ContactProblem& problem, int digits);

  Decimal end(End which) const;
  /// Returns `edge` or `free`.
  SingularKind kind(End which) const;
  /// Returns t(x); 0 outside the contact. Throws std::domain_error if x is an end, a friction jump inside the contact,
  /// or so close to a free end that the working precision cannot distinguish them.
  Decimal traction(const Rational& x) const;
  /// Returns the derivation of this contact with the problem's numbers.
  Derivation derivation() const;

 private:
  struct State;
  explicit DerivedContact(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

}  // namespace steadyslide::symbolic
