#pragma once
// Closed-form tractions to any number of digits, in CLN. They check the closed forms of the numeric layer and share
// only the model with it. Each has the form
//
//   t(x) = -K cos(pi alpha(x)) prod_j |x - e_j|^{p_j},   e_j: the contact's ends and the friction jumps inside it,
//   flat punch [Bal16, (4), (5)-(7)]:   K = load/pi,  p = -(1/2+alpha_0), beta_1, ..., -(1/2-alpha_m),
//   Galin's parabola:                   K = 1/R,      p = 1/2-alpha, beta, ..., 1/2+alpha.
//
// beta = alpha(c-) - alpha(c+), pi alpha = arctan(s), s = problem.coupled_friction. The user's units and the user's x.
// A parabola psi = A x^2 + B x + C has R = c/(2A), c the compliance; with r = x + B/(2A), its contact ends solve
//   sum p_j r_j = 0,   sum p_j r_j^2 = 2 load R / pi.
// Not thread-safe, because CLN is not.

#include <cstddef>
#include <memory>
#include <vector>

#include "model/contact_problem.hpp"
#include "symbolic/cln/decimal.hpp"

namespace steadyslide::symbolic {

class ClnClosedForm {
 public:
  /// Returns the flat punch in full contact. Throws std::domain_error unless the profile is one constant, the indenter
  /// is rigid and cannot tilt, and digits >= 1.
  static ClnClosedForm flat_punch(const ContactProblem& problem, int digits);

  /// Returns, from left to right, every contact zone inside the support that satisfies the parabola's two equations
  /// with the jumps it contains. The list is empty if the contact reaches an edge. Newton's method finds the ends, once
  /// for each range of neighbouring jumps. An end that agrees with a jump to all digits is taken to lie beside the
  /// jump. Throws std::domain_error unless the profile is one parabola that opens upwards (A > 0), the indenter cannot
  /// tilt, and digits >= 1.
  static std::vector<ClnClosedForm> parabola(const ContactProblem& problem, int digits);

  Decimal left() const;
  Decimal right() const;
  /// The friction jumps strictly inside the contact have first_jump() <= index < last_jump().
  std::size_t first_jump() const;
  std::size_t last_jump() const;
  /// t(x) <= 0 strictly inside the contact, 0 outside of it. Throws std::domain_error if x is an edge or a friction
  /// jump inside the contact, or so close to a free end that the working precision cannot distinguish them.
  Decimal traction(const Rational& x) const;

 private:
  struct State;
  explicit ClnClosedForm(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

}  // namespace steadyslide::symbolic
