#pragma once
// The fundamental solution Y of a contact set on the real line, with its sign: Y itself off the contact, and on it
// eps = +-1 from Y+ = eps |Y|/((s+i) cos(pi alpha)).

#include <vector>

#include "numeric/cauchy/fundamental_solution.hpp"
#include "numeric/riemann_hilbert/contact_set.hpp"

namespace steadyslide::numeric {

template <Real R>
class SignedFundamentalSolution {
 public:
  /// `problem` has to outlive it.
  SignedFundamentalSolution(const ReducedProblem<R>& problem, ContactSet<R> set);

  const ReducedProblem<R>& problem() const { return *problem_; }
  const ContactSet<R>& set() const { return set_; }
  const FundamentalSolution<R>& fundamental_solution() const { return solution_; }
  /// S: Y ~ z^S.
  int degree_at_infinity() const { return degree_; }

  /// The power of Y at point j.
  const Power<R>& power(std::size_t j) const { return solution_.powers()[j]; }
  /// The power of the traction at point j, with its exact form; zero where Y has none.
  const Exponent& exponent(std::size_t j) const;
  std::size_t slope_at(std::size_t segment) const { return problem_->slope_of(set_.interval(segment)); }
  std::size_t friction_at(std::size_t segment) const { return problem_->friction_of(set_.interval(segment)); }
  /// Does the profile change its polynomial at j, within the contact?
  bool changes_polynomial(std::size_t j) const;

  /// eps on a segment in contact; the sign of Y on any other, -1 and the number of segments included.
  int sign(std::ptrdiff_t segment) const { return signs_[static_cast<std::size_t>(segment + 1)]; }
  R modulus(const SurfacePoint<R>& at) const;
  /// Y off the contact.
  R value(const SurfacePoint<R>& at) const { return sign(at.segment) * modulus(at); }
  /// eps cos(pi alpha) on a segment in contact.
  R traction_factor(std::size_t segment) const;
  /// x - x_j.
  R distance(const SurfacePoint<R>& at, std::size_t j) const;

 private:
  const ReducedProblem<R>* problem_;
  ContactSet<R> set_;
  FundamentalSolution<R> solution_;
  std::vector<int> signs_;
  int degree_;
};

}  // namespace steadyslide::numeric
