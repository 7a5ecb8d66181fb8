#pragma once
// The fundamental solution Y of a contact set on the real line, with its sign: outside the contact Y itself, on the
// contact eps = +-1 from Y+ = eps |Y|/((s+i) cos(pi alpha)).
//
// For n components with free ends, |Y| varies along the surface by a factor like e^n, and the influence of the other
// components at one place would be a small difference of large terms. So for many components Y has degree 0 on each,
// and is near 1 away from all of them: at one end of component i, its pivot e_i, the power is one too low or one too
// high, and
//
//   Y_i = Y (z - e_i)^sigma_i,   sigma_i = 1: both ends are free, 0: one is, -1: none is,
//
// has the powers of component i. A place in or beside component i uses Y_i.

#include <vector>

#include "numeric/cauchy/fundamental_solution.hpp"
#include "numeric/riemann_hilbert/contact_set.hpp"

namespace steadyslide::numeric {

template <Real R>
class SignedFundamentalSolution {
 public:
  /// `problem` must outlive this object.
  SignedFundamentalSolution(const RoundedProblem<R>& problem, ContactSet<R> set);

  const RoundedProblem<R>& problem() const { return *problem_; }
  const ContactSet<R>& set() const { return set_; }
  const FundamentalSolution<R>& fundamental_solution() const { return solution_; }
  /// Returns S, with Y ~ z^S.
  int degree_at_infinity() const { return degree_; }

  struct Pivot {
    std::size_t point;
    int order;  ///< sigma
  };
  /// Returns the pivot of each component; empty if Y has the powers of all components.
  const std::vector<Pivot>& pivots() const { return pivots_; }
  /// Returns the component of a place, or of a point in contact or at an end of contact.
  std::size_t component_at(const SurfacePoint<R>& at) const;
  std::size_t component_of(std::size_t j) const;
  /// Returns (x - e_i)^sigma_i at a place of component i; 1 without pivots.
  R to_pivot(const SurfacePoint<R>& at) const;
  /// Returns |Y|, without that factor.
  R common_modulus(const SurfacePoint<R>& at) const;

  /// Returns the power of Y_i at point j of component i.
  const Power<R>& power(std::size_t j) const { return powers_[j]; }
  /// Returns the power of Y_i at a point j, for any component i.
  const Power<R>& power(std::size_t j, std::size_t component) const {
    return pivots_.empty() || component_of(j) == component ? powers_[j] : solution_.powers()[j];
  }
  /// Returns the higher one of both.
  const Power<R>& highest_power(std::size_t j) const {
    return powers_[j].value < solution_.powers()[j].value ? solution_.powers()[j] : powers_[j];
  }
  /// Returns the factor of |x - x_j|^power(j) in |Y_i| at point j of component i.
  R amplitude(std::size_t j) const;
  /// Returns |Y_i| in a segment of component i without the powers of its two points.
  R smooth_modulus(std::size_t segment, const Node<R>& node) const;
  /// Returns the power of the traction at point j, in exact form; 0 if Y has no power there.
  const Exponent& exponent(std::size_t j) const;
  std::size_t slope_at(std::size_t segment) const { return problem_->slope_of(set_.interval(segment)); }
  std::size_t friction_at(std::size_t segment) const { return problem_->friction_of(set_.interval(segment)); }
  /// True if the profile changes its polynomial at j, inside the contact.
  bool changes_polynomial(std::size_t j) const;

  /// Returns eps of Y_i on a segment in contact; on any other segment the sign of Y. `segment` may be -1 or the number
  /// of segments.
  int sign(std::ptrdiff_t segment) const { return signs_[static_cast<std::size_t>(segment + 1)]; }
  /// Returns eps of Y_i; outside the contact the sign of Y_i.
  int sign(const SurfacePoint<R>& at) const;
  /// Returns |Y_i|.
  R modulus(const SurfacePoint<R>& at) const;
  /// Returns Y_i outside the contact.
  R value(const SurfacePoint<R>& at) const { return sign(at) * modulus(at); }
  /// Returns eps cos(pi alpha) on a segment in contact, with eps of the Y_i of its own component, or of the given
  /// component.
  R traction_factor(std::size_t segment) const;
  R traction_factor(std::size_t segment, std::size_t component) const;
  /// Returns x - x_j.
  R distance(const SurfacePoint<R>& at, std::size_t j) const;
  /// Returns x - x_j for all points.
  std::vector<R> distances(const SurfacePoint<R>& at) const;
  /// Returns the same for the ends of contact, and 0 for the other points. Blocks of segments are summed at once.
  std::vector<R> distances_of_ends(const SurfacePoint<R>& at) const;

 private:
  void assign_components();
  /// True if component i, of order 1 or -1, is on the left of its pivot. Then x - e_i < 0 there.
  bool is_left_of_pivot(std::size_t segment, std::size_t component) const { return segment < pivots_[component].point; }

  const RoundedProblem<R>* problem_;
  ContactSet<R> set_;
  std::vector<Power<R>> powers_;
  std::vector<Pivot> pivots_;
  std::vector<std::size_t> left_component_;  ///< the component of the left half of a segment
  std::vector<std::size_t> right_component_;
  FundamentalSolution<R> solution_;
  std::vector<int> signs_;
  int degree_ = 0;
};

}  // namespace steadyslide::numeric
