#pragma once
// The solution of periodic contact on one zone in each period, as a ContactSolution. Its traction is that of
// periodic_traction.hpp. Places are moved into one period, because all fields are periodic: the period that begins at the
// support's left end, or in the middle of the gap if the contact lies across that end. The load up to x, T(x), is counted
// from the support's left end, u is 0 at problem.origin_of_displacement(), and
//
//   u_t'/c = (1/L) PV int t_t cot(pi (x'-x)/L) dx' + gamma (t + P/L).

#include <memory>

#include "numeric/number/once.hpp"
#include "numeric/periodic/periodic_contact.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::numeric {

template <Real R>
class PeriodicSolution : public ContactSolution<R> {
 public:
  PeriodicSolution(ContactProblem problem, PeriodicContact<R> found);

  std::string method() const override { return "closed-form"; }
  std::vector<ContactComponent<R>> contact() const override;
  ApproximateContact approximate_contact() const override;
  std::vector<SolvedSingularPoint<R>> singular_points() const override;
  Resultants<R> resultants() const override;
  LargestPressure<R> largest_pressure() const override;
  EstimatedError<R> estimated_error() const override;
  Residuals<R> residuals() const override;
  Sample<R> at(const Rational& x) const override;
  PiecewiseTraction<R> piecewise_traction() const override { return panels(); }
  std::vector<Sample<R>> samples(int count) const override;
  DetailedSample<R> details_at(const Rational& x) const override;
  std::vector<DetailedSample<R>> detailed_samples(int count) const override;

 private:
  const PeriodicTraction<R>& traction() const { return found_.traction; }
  const PeriodicFundamentalSolution<R>& weight() const { return found_.traction.weight; }
  std::size_t gap() const { return found_.traction.gap(); }
  bool is_free(std::size_t point) const;
  Estimate<R> place(std::size_t point) const;
  std::size_t piece(std::size_t arc) const { return found_.pieces[arc]; }
  /// Returns the length of the contact.
  R width() const { return traction().has_gap() ? R(weight().period() - weight().arc(gap())) : weight().period(); }
  SingularKind end_of(std::size_t point) const {
    if (!traction().has_gap()) return SingularKind::friction_jump;
    return is_free(point) ? SingularKind::free : SingularKind::edge;
  }
  Exponent exponent(std::size_t point) const;
  Estimate<R> intensity(std::size_t point) const;
  /// Returns the estimated relative error of value() on an arc.
  R relative_error(std::size_t arc, const R& from_left, const R& from_right) const;

  /// Returns the beginning of the period.
  Rational begin() const;
  /// Returns the end of the part of the period that has an indenter.
  Rational end() const { return begin() + problem_.indenter().right() - problem_.indenter().left(); }
  /// A place of the circle: a point, or a place of an arc. `x` is the user's x in the period.
  struct Place {
    Rational x;
    std::size_t arc;  ///< the arc, or the one that begins at the point
    bool is_point;
    R from_left = 0, from_right = 0;
  };
  Place locate(const Rational& x) const;
  std::vector<Rational> sampled_places(int count) const;
  Sample<R> at(const Place& place) const;
  Sample<R> at_point(const Place& place) const;
  DetailedSample<R> details(const Place& place) const;
  /// Returns int value() over the part of an arc between one of its ends and a place.
  Estimate<R> part(const Place& place, Side end) const;
  /// Returns psi - u - C, also outside the support; 0 in contact.
  Estimate<R> gap_at(const Place& place) const;
  /// Returns psi and psi', divided by c, at a place, without the constant of psi.
  std::pair<Estimate<R>, Estimate<R>> profile(const Rational& x) const;
  template <class Kernel>
  R trapezoidal_integral(std::size_t arc, const R& from_left, const R& from_right, const Kernel& kernel) const;
  R hilbert(std::size_t arc, const R& from_left, const R& from_right) const;
  /// Returns the sum of the arcs from one to another, without the last.
  R way(std::size_t from, std::size_t to) const;
  Estimate<R> shear_slope(const Place& place, const Sample<R>& sample) const;
  /// Returns S = (1/L) int s p dx.
  Estimate<R> mean_friction() const;
  const std::vector<Estimate<R>>& loads() const;
  const PiecewiseTraction<R>& panels() const;

  ContactProblem problem_;
  R compliance_;
  PeriodicContact<R> found_;
  Once<std::vector<Estimate<R>>> loads_;  ///< -int t over each arc of the contact
  Once<PiecewiseTraction<R>> panels_;
};

/// Solves periodic contact by a closed form: a flat punch in full contact of its support, or harmonics with one zone of
/// contact in each period; both also without a gap; with friction jumps. Without a gap, the contact is said to end at the
/// ends of the support, with the kind of a friction jump.
template <Real R>
Attempt<R> periodic_closed_form(const ContactProblem& problem);

}  // namespace steadyslide::numeric
