#pragma once
// The solution of A t = g + tilt on a given contact set K, the profile's slope g a polynomial g_k on each piece,
// derived in docs/theory.md:
//
//   u'/c = g_k + tilt - Y B_k outside the contact,   t = eps cos(pi alpha) |Y| B_k on it,
//   B_k(x) = [(g_k + tilt)/Y]_poly - q(x)/pi - (1/pi) int_K eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x),
//
// which is the same function for every k. With k from the piece at x there is no principal value. [Bal16, theorem 36,
// reconstructed]
//
// For many components Y has degree 0 (signed_fundamental_solution.hpp), and instead of q every component without a free
// end has a number theta_i:
//
//   (u'/c - g_k - tilt)/Y = -B,   B = [(g_k + tilt)/Y]_poly - sum_j theta_j/(pi (x - e_j)) - (1/pi) int ...,
//
// and beside component i the same with Y_i and B_i = (x - e_i)^-sigma_i (B - B(e_i)); the term B(e_i) only if
// sigma_i = 1.

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "numeric/number/estimate.hpp"
#include "numeric/riemann_hilbert/contact_quadrature.hpp"
#include "numeric/riemann_hilbert/expansion_at_infinity.hpp"

namespace steadyslide::numeric {

template <Real R>
class TractionRepresentation {
 public:
  /// `q` are the coefficients of 1, xi, ...; empty if S >= 0; theta of each component if Y has pivots. `problem` and
  /// `rules` must outlive the form.
  TractionRepresentation(const RoundedProblem<R>& problem, ContactSet<R> set, std::vector<R> q, const R& tilt,
                         JacobiRules<R>& rules);

  const SignedFundamentalSolution<R>& y() const { return *y_; }
  const ExpansionAtInfinity<R>& expansion() const { return expansion_; }
  const std::vector<R>& q() const { return q_; }
  const R& tilt() const { return tilt_; }

  // Functions of Y.
  const RoundedProblem<R>& problem() const { return y_->problem(); }
  const ContactSet<R>& set() const { return y_->set(); }
  const FundamentalSolution<R>& fundamental_solution() const { return y_->fundamental_solution(); }
  int degree_at_infinity() const { return y_->degree_at_infinity(); }
  const Exponent& exponent(std::size_t j) const { return y_->exponent(j); }
  std::size_t slope_at(std::size_t segment) const { return y_->slope_at(segment); }
  std::size_t friction_at(std::size_t segment) const { return y_->friction_at(segment); }
  bool changes_polynomial(std::size_t j) const { return y_->changes_polynomial(j); }
  int sign(std::ptrdiff_t segment) const { return y_->sign(segment); }
  int sign(const SurfacePoint<R>& at) const { return y_->sign(at); }
  const Power<R>& power(std::size_t j) const { return y_->power(j); }
  R amplitude(std::size_t j) const { return y_->amplitude(j); }
  R modulus(const SurfacePoint<R>& at) const { return y_->modulus(at); }
  R distance(const SurfacePoint<R>& at, std::size_t j) const { return y_->distance(at, j); }
  std::vector<R> distances(const SurfacePoint<R>& at) const { return y_->distances(at); }

  /// Returns B_k with its rounding error.
  Estimate<R> regular_factor(std::size_t slope, const SurfacePoint<R>& at) const;
  /// Returns B_k without its error.
  R regular_value(std::size_t slope, const SurfacePoint<R>& at) const;
  /// True if B_k is constant: one polynomial of degree 0 and one component.
  bool regular_value_is_constant(std::size_t slope) const;
  /// Returns B_k at point j of the set, where k is the slope on that side. If the contact changes its polynomial at j,
  /// returns B_k without its singular term there (a multiple of |x - x_j|^-p, or of log|x - x_j| if p = 0).
  Estimate<R> regular_factor_at(std::size_t j, Side side) const;
  /// Returns the error of B_k at a place due to these errors; at a free end, due to the errors of the other ends.
  /// Neighbouring solutions differ by Y (sum_f p_f B(e_f) de_f/(z - e_f) + r(z)); with pivots, the terms of other
  /// components have the additional factor (Y_j/Y_i)(e_f).
  R error_of_state(const SurfacePoint<R>& at, const StateErrors<R>& errors) const;
  /// Returns t; zero outside the contact.
  Estimate<R> traction(const SurfacePoint<R>& at) const;
  /// Computes t at many points of a segment in contact, given by their distances from its ends, without errors; |Y| as
  /// by FundamentalSolution::moduli.
  void tractions(std::size_t segment, std::span<const R> from_left, std::span<const R> from_right,
                 std::span<R> values) const;
  /// Returns the tilted profile's g at a point; beyond the support that of the last piece.
  Estimate<R> profile_slope(const SurfacePoint<R>& at) const;
  /// Returns the reduced slope u'/c.
  Estimate<R> surface_slope(const SurfacePoint<R>& at) const;
  /// Returns int t over a segment in contact. The polynomial must not change at its two points.
  Estimate<R> load_on(std::size_t segment) const;
  /// Returns m_j in u'/(c Y) = m_0/z + m_1/z^2 + ..., plus the polynomial q/pi.
  std::vector<Estimate<R>> moments(std::size_t count) const;
  /// Returns -int xi t.
  Estimate<R> moment_of_load() const;
  /// Returns B(e_i), where e_i is the pivot of a component without an edge. It is 0 for a solution.
  const Estimate<R>& pivot_moment(std::size_t component) const;

  /// Returns the valleys and peaks of the tilted profile over a segment. Contact is sought there first, even if they
  /// are very small compared with the segment.
  std::vector<SurfacePoint<R>> profile_extrema(std::size_t segment) const;

  /// Returns rules over a part of a segment for B_k times powers of the distances to points j, power_at(j).
  std::vector<JacobiPanel<R>> panels(const SegmentPart<R>& part,
                                     const std::function<Power<R>(std::size_t)>& power_at) const {
    return jacobi_panels(*y_, part, SmoothFactor::regular_factor, power_at, *rules_);
  }
  /// Returns graded panels with one node each, for errors of |Y| B_k, which are needed only in order of magnitude.
  std::vector<JacobiPanel<R>> error_panels(const SegmentPart<R>& part) const;
  /// Returns int error over a part of a segment, by these panels.
  R integral_of_error(const SegmentPart<R>& part, const std::function<R(const SurfacePoint<R>&)>& error) const;

 private:
  std::size_t nearest_segment(const SurfacePoint<R>& at) const {
    return static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(at.segment, 0, static_cast<std::ptrdiff_t>(set().segments()) - 1));
  }

  JacobiRules<R>* rules_;
  std::shared_ptr<const SignedFundamentalSolution<R>> y_;  ///< the quadrature points to it, also in copies
  std::vector<R> q_;
  R tilt_;
  ExpansionAtInfinity<R> expansion_;
  ContactQuadrature<R> quadrature_;
  std::vector<std::vector<R>> polynomials_;  ///< for each k, the coefficients of [(g_k + tilt)/Y]_poly - q/pi
  std::vector<std::vector<R>> sizes_;        ///< the sums of absolute values for each of them
  Estimate<R> pivoted_polynomial(std::size_t slope, const SurfacePoint<R>& at) const;

  std::vector<std::size_t> poles_;  ///< components with a theta
  Estimate<R> load_without_poles_;  ///< the coefficient of 1/z in u'/(c Y) without the poles
  std::shared_ptr<std::mutex> making_ = std::make_shared<std::mutex>();  ///< protects the next members
  mutable std::vector<std::optional<Estimate<R>>> pivot_moments_;
  mutable std::vector<std::optional<Estimate<R>>> end_factors_;  ///< B_k at the ends of contact, which is used often
};

}  // namespace steadyslide::numeric
