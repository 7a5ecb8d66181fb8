#pragma once
// Archard's law of wear: the indenter loses the depth w,
//
//   dw/dS = k(x) p(x),   S the sliding distance, p the pressure,
//
// with one k for each coating. A point of the body is passed once: behind the place x stands a depth of
// k_b times the load that has passed there. It does not add up.

#include <vector>

#include "model/contact_problem.hpp"

namespace steadyslide {

class Wear {
 public:
  /// Takes k, one for each friction value from left to right or one for all, and k_b. Throws InvalidData unless all are
  /// >= 0 and one k is positive. A body that comes back with a period does not wear: k_b = 0.
  Wear(std::vector<Rational> coefficients, Rational body, const ContactProblem& problem);

  /// Returns k on a friction piece, one over a pressure.
  const Rational& coefficient(std::size_t piece) const { return coefficients_[coefficients_.size() == 1 ? 0 : piece]; }
  const std::vector<Rational>& coefficients() const { return coefficients_; }
  /// Returns k_b, one over a pressure.
  const Rational& body() const { return body_; }
  friend bool operator==(const Wear&, const Wear&) = default;

 private:
  std::vector<Rational> coefficients_;
  Rational body_;
};

}  // namespace steadyslide
