#pragma once
// The derived tractions to any number of digits, in CLN. Nothing of the closed form is written here: exponents from the
// operator, epsilon decided on the panels, N = Q + q and the ends' conditions from the series at infinity
// (riemann_hilbert.hpp, polynomial_slope.hpp); evaluated are those expressions:
//
//   t(x) = epsilon cos(pi alpha(x)) prod |x - e_j|^{p_j} N(x).
//
// For one contact under one profile psi = A x^2 + B x + C, A >= 0: flat, tilted or a parabola, each end an edge of the
// support or free, any number of friction jumps. The user's units and the user's x. Not thread-safe, as GiNaC is not.

#include <memory>
#include <vector>

#include "model/contact_problem.hpp"
#include "model/singular_point.hpp"
#include "symbolic/cln/decimal.hpp"
#include "symbolic/field/derivation.hpp"

namespace steadyslide::symbolic {

class DerivedContact {
 public:
  /// Every contact whose ends satisfy their conditions inside the support and whose traction is nowhere positive. Ends
  /// by Newton's method. Throws std::domain_error unless the profile is as above, without tilt, and digits >= 1.
  static std::vector<DerivedContact> all(const ContactProblem& problem, int digits);

  Decimal end(End which) const;
  /// edge or free
  SingularKind kind(End which) const;
  /// 0 outside the contact. Throws std::domain_error at an end, at a friction jump inside the contact, and where x is
  /// so near a free end that the digits carried do not tell them apart.
  Decimal traction(const Rational& x) const;
  /// How this contact comes about, with the problem's numbers.
  Derivation derivation() const;

 private:
  struct State;
  explicit DerivedContact(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

}  // namespace steadyslide::symbolic
