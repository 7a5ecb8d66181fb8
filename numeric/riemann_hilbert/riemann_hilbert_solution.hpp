#pragma once
// The solution that riemann_hilbert() returns: the Riemann-Hilbert form of a contact problem in the user's units and x.

#include <functional>
#include <map>
#include <mutex>

#include "numeric/cauchy/residuals.hpp"
#include "numeric/cauchy/traction_integrals.hpp"
#include "numeric/riemann_hilbert/contact_search.hpp"
#include "numeric/riemann_hilbert/gap_integral.hpp"

namespace steadyslide::numeric {

template <Real R>
class RiemannHilbertSolution : public ContactSolution<R> {
 public:
  /// A function that finds the contact of the reduced problem. The form keeps using the rules.
  using Search = std::function<SearchResult<R>(const RoundedProblem<R>&, JacobiRules<R>&)>;
  RiemannHilbertSolution(ContactProblem problem, const Frame& frame, const Search& search);
  // Not copyable, because the form points into this object.
  RiemannHilbertSolution(const RiemannHilbertSolution&) = delete;
  RiemannHilbertSolution& operator=(const RiemannHilbertSolution&) = delete;

  const RoundedProblem<R>& problem() const { return reduced_; }
  const ContactState<R>& state() const { return found_.state; }
  const StateErrors<R>& state_errors() const { return found_.errors; }
  const std::vector<HairlineGap<R>>& hairline_gaps() const { return found_.hairline_gaps; }
  const TractionRepresentation<R>& form() const { return form_; }
  /// True if the traction blows up at an end.
  bool has_edge() const;

  std::string method() const override { return "riemann-hilbert"; }
  std::string failed_condition() const override { return found_.failed_condition; }
  std::vector<ContactComponent<R>> contact() const override;
  std::vector<UnresolvedGap<R>> unresolved_gaps() const override;
  ApproximateContact approximate_contact() const override;
  std::vector<SolvedSingularPoint<R>> singular_points() const override;
  Resultants<R> resultants() const override;
  LargestPressure<R> largest_pressure() const override;
  std::optional<Estimate<R>> tilt() const override;
  EstimatedError<R> estimated_error() const override;
  Residuals<R> residuals() const override;
  Sample<R> at(const Rational& x) const override;
  void tractions(std::span<const R> x, std::span<R> normal, std::span<R> shear) const override;
  PiecewiseTraction<R> piecewise_traction() const override;
  std::vector<Sample<R>> samples(int count) const override;
  DetailedSample<R> details_at(const Rational& x) const override;
  std::vector<DetailedSample<R>> detailed_samples(int count) const override;

  /// Returns only u_t' at a place that is not a singular point.
  Estimate<R> tangential_slope(const Rational& x) const;

  // Functions that integrals of the traction need.
  SurfacePoint<R> locate(const Rational& x) const;
  /// Returns t_t/t on a segment.
  R shear_ratio(std::size_t segment) const;
  /// Returns the relative error of the traction at a place due to the error of the free ends.
  R relative_end_error(const SurfacePoint<R>& at) const;

 private:
  const ContactSet<R>& contact_set() const { return form_.set(); }
  const R& end_error() const { return found_.errors.ends.distance; }
  /// Returns the relative change of the other points' powers due to the error of free end j; 0 if point j does not
  /// move.
  R relative_shift(std::size_t j) const;
  Estimate<R> coordinate(std::size_t j) const;
  std::vector<Rational> places() const;
  SurfacePoint<R> middle_of(std::size_t segment) const;
  ContactEnd<R> contact_end(std::size_t j) const;
  /// Returns the coefficient of |x - x_j|^p/cos(pi alpha) in t on one side of point j; for p = 0, the part of t without
  /// its singular term.
  Estimate<R> amplitude(std::size_t j, Side side) const;
  /// Returns theta of a power.
  Estimate<R> intensity(std::size_t j) const;
  /// Returns the traction with its error, including that of the state.
  Estimate<R> traction(const SurfacePoint<R>& at) const;
  Estimate<R> constant(std::size_t j) const;
  /// Returns the exact terms at point j inside the contact; absent if nothing jumps there.
  std::optional<InnerTerms> inner_terms_at(std::size_t j) const;
  bool in_contact_at(std::size_t j, Side side) const;

  std::optional<std::size_t> point_at(const SurfacePoint<R>& at) const;
  /// Returns u' at a place that is not a singular point, with its error, including that of the state.
  Estimate<R> slope(const SurfacePoint<R>& at) const;
  Sample<R> sample(const SurfacePoint<R>& at) const;
  Sample<R> sample_at_point(std::size_t j) const;
  Estimate<R> traction_limit(std::size_t j, Side side) const;
  Estimate<R> slope_limit(std::size_t j, Side side) const;
  Estimate<R> gap(const SurfacePoint<R>& at) const;
  /// Returns TractionSegment::left_corner or right_corner of the segment on that side of point j.
  std::function<R(const R&)> corner(std::size_t j, Side side) const;
  std::optional<std::size_t> nearest_end(const SurfacePoint<R>& at) const;

  /// Returns the places of samples().
  std::vector<SurfacePoint<R>> sampled_places(int count) const;
  /// Returns psi + tilt x - gap, which is u + C. `gap_there` is the gap if it is already known.
  Estimate<R> height(const SurfacePoint<R>& at, std::optional<Estimate<R>> gap_there = std::nullopt) const;
  Estimate<R> height_beyond(const SurfacePoint<R>& at) const;
  LinePlace<R> line_place(const SurfacePoint<R>& at, std::optional<std::size_t> point) const;
  DetailedSample<R> detailed(const SurfacePoint<R>& at) const;
  const TractionIntegrals<R>& integrals() const;

  /// Returns int t over each segment in contact, in xi.
  const std::vector<Estimate<R>>& loads() const;

  /// Returns the traction sampled by the rule for residuals, which is also the fastest rule for loads in high
  /// precision. Its panels are the segments in contact.
  const SurfaceCheck<R>& check() const;

  ContactProblem problem_;
  R compliance_;
  RoundedProblem<R> reduced_;
  R unit_;  ///< unit of xi
  JacobiRules<R> rules_;
  SearchResult<R> found_;
  TractionRepresentation<R> form_;
  Once<SurfaceCheck<R>> check_;
  Once<Resultants<R>> resultants_;
  Once<EstimatedError<R>> estimated_error_;
  Once<std::vector<Estimate<R>>> loads_;
  Once<TractionIntegrals<R>> integrals_;
  Once<Estimate<R>> height_at_origin_;
  mutable std::mutex measuring_;                        ///< protects the gaps
  mutable std::map<std::size_t, GapIntegral<R>> gaps_;  ///< by end of contact; they keep sums over whole segments
};

}  // namespace steadyslide::numeric
