#pragma once
// The fundamental solution Y of a contact set on the real line, with its sign: Y itself off the contact, and on it
// eps = +-1 from Y+ = eps |Y|/((s+i) cos(pi alpha)).
//
// Of n components with free ends |Y| differs from place to place by a factor like e^n: what one place sees of the others
// would be a small difference of large terms. So the Y of many components is of degree 0 on each, and near 1 away from
// all of them: one end of component i, its pivot e_i, has a power by one too low or too high, and
//
//   Y_i = Y (z - e_i)^sigma_i,   sigma_i = 1: both ends are free, 0: one is, -1: none is,
//
// has the powers of component i. A place belongs to the component it lies in or beside, and sees its Y_i.

#include <vector>

#include "numeric/cauchy/fundamental_solution.hpp"
#include "numeric/riemann_hilbert/contact_set.hpp"

namespace steadyslide::numeric {

template <Real R>
class SignedFundamentalSolution {
 public:
  /// `problem` has to outlive it.
  SignedFundamentalSolution(const RoundedProblem<R>& problem, ContactSet<R> set);

  const RoundedProblem<R>& problem() const { return *problem_; }
  const ContactSet<R>& set() const { return set_; }
  const FundamentalSolution<R>& fundamental_solution() const { return solution_; }
  /// S: Y ~ z^S.
  int degree_at_infinity() const { return degree_; }

  struct Pivot {
    std::size_t point;
    int order;  ///< sigma
  };
  /// Of each component; empty where Y has all the powers itself.
  const std::vector<Pivot>& pivots() const { return pivots_; }
  /// The component that a place, or a point in contact or at an end of it, belongs to.
  std::size_t component_at(const SurfacePoint<R>& at) const;
  std::size_t component_of(std::size_t j) const;
  /// (x - e_i)^sigma_i at a place that belongs to component i; 1 without pivots.
  R to_pivot(const SurfacePoint<R>& at) const;
  /// |Y|, without that factor.
  R common_modulus(const SurfacePoint<R>& at) const;

  /// The power of Y_i at point j of component i.
  const Power<R>& power(std::size_t j) const { return powers_[j]; }
  /// The power of Y_i at a point j, for any component i.
  const Power<R>& power(std::size_t j, std::size_t component) const {
    return pivots_.empty() || component_of(j) == component ? powers_[j] : solution_.powers()[j];
  }
  /// The higher one of both.
  const Power<R>& highest_power(std::size_t j) const {
    return powers_[j].value < solution_.powers()[j].value ? solution_.powers()[j] : powers_[j];
  }
  /// What multiplies |x - x_j|^power(j) in |Y_i| at point j of component i.
  R amplitude(std::size_t j) const;
  /// |Y_i| in a segment of component i without the powers of its two points.
  R smooth_modulus(std::size_t segment, const Node<R>& node) const;
  /// The power of the traction at point j, with its exact form; zero where Y has none.
  const Exponent& exponent(std::size_t j) const;
  std::size_t slope_at(std::size_t segment) const { return problem_->slope_of(set_.interval(segment)); }
  std::size_t friction_at(std::size_t segment) const { return problem_->friction_of(set_.interval(segment)); }
  /// Does the profile change its polynomial at j, within the contact?
  bool changes_polynomial(std::size_t j) const;

  /// eps of Y_i on a segment in contact; the sign of Y on any other, -1 and the number of segments included.
  int sign(std::ptrdiff_t segment) const { return signs_[static_cast<std::size_t>(segment + 1)]; }
  /// eps of Y_i, or the sign of Y_i off the contact.
  int sign(const SurfacePoint<R>& at) const;
  /// |Y_i|.
  R modulus(const SurfacePoint<R>& at) const;
  /// Y_i off the contact.
  R value(const SurfacePoint<R>& at) const { return sign(at) * modulus(at); }
  /// eps cos(pi alpha) on a segment in contact, eps of the Y_i of its own component; of another one's.
  R traction_factor(std::size_t segment) const;
  R traction_factor(std::size_t segment, std::size_t component) const;
  /// x - x_j.
  R distance(const SurfacePoint<R>& at, std::size_t j) const;
  /// The same of all points.
  std::vector<R> distances(const SurfacePoint<R>& at) const;

 private:
  void assign_components();
  /// Is component i, of order 1 or -1, on the left of its pivot? Then x - e_i < 0 there.
  bool is_left_of_pivot(std::size_t segment, std::size_t component) const { return segment < pivots_[component].point; }

  const RoundedProblem<R>* problem_;
  ContactSet<R> set_;
  std::vector<Power<R>> powers_;
  std::vector<Pivot> pivots_;
  std::vector<std::size_t> left_component_;  ///< that the left half of a segment belongs to
  std::vector<std::size_t> right_component_;
  FundamentalSolution<R> solution_;
  std::vector<int> signs_;
  int degree_;
};

}  // namespace steadyslide::numeric
