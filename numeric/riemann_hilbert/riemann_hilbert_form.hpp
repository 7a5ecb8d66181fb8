#pragma once
// The solution of A t = g + tilt on a given contact set K, for a profile slope g that is a polynomial g_k on each
// piece:
//
//   u'/c = g_k + tilt - Y B_k off the contact,   t = eps cos(pi alpha) |Y| B_k on it,
//   B_k(x) = [(g_k + tilt)/Y]_poly - q(x)/pi - (1/pi) int_K eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x),
//
// for every k the same function. [.]_poly is the polynomial part at infinity, S the degree of Y there, q a polynomial
// of degree -S-1 with the load as its leading coefficient (none if S >= 0), eps = +-1 on each component: Y+ = eps
// |Y|/((s+i) cos(pi alpha)). Taking k from the piece at x, the integral stays clear of x: there is no principal value,
// and t has its exact local form next to ends, jumps and wedges. [Bal16, theorem 36, reconstructed]

#include <functional>
#include <optional>
#include <vector>

#include "numeric/number/estimate.hpp"
#include "numeric/quadrature/graded_panels.hpp"
#include "numeric/quadrature/jacobi_rule.hpp"
#include "numeric/riemann_hilbert/contact_set.hpp"

namespace steadyslide::numeric {

/// A point of the surface: in a segment of the contact set, or at the distance `from_right` to the left of the support
/// (segment -1), or at the distance `from_left` to the right of it (segment = number of segments).
template <Real R>
struct SurfacePoint {
  std::ptrdiff_t segment;
  Node<R> node;
};

/// In a segment, the place taken from the nearer end.
template <Real R>
SurfacePoint<R> surface_point(const ContactSet<R>& set, std::size_t segment, const R& from_left, const R& from_right) {
  const R x = from_left < from_right ? R(set.x(segment) + from_left) : R(set.x(segment + 1) - from_right);
  return {static_cast<std::ptrdiff_t>(segment), {x, from_left, from_right}};
}

/// At the distance d from point j of the set, on that side of it; beyond the support the other distance is infinite.
template <Real R>
SurfacePoint<R> beside(const ContactSet<R>& set, std::size_t j, Side side, const R& d) {
  const bool left = side == Side::left;
  const std::ptrdiff_t segment = static_cast<std::ptrdiff_t>(j) - (left ? 1 : 0);
  const bool in_support = segment >= 0 && segment < static_cast<std::ptrdiff_t>(set.segments());
  const R rest = in_support ? R(set.length(static_cast<std::size_t>(segment)) - d) : infinity<R>();
  return {segment, left ? Node<R>{set.x(j) - d, rest, d} : Node<R>{set.x(j) + d, d, rest}};
}

template <Real R>
class RiemannHilbertForm {
 public:
  /// `q`: coefficients of 1, xi, ...; empty if S >= 0. `problem` and `rules` have to outlive the form.
  RiemannHilbertForm(const ReducedProblem<R>& problem, ContactSet<R> set, std::vector<R> q, const R& tilt,
                     JacobiRules<R>& rules);

  const ReducedProblem<R>& problem() const { return *problem_; }
  const ContactSet<R>& set() const { return set_; }
  const FundamentalSolution<R>& weight() const { return weight_; }
  int degree_at_infinity() const { return degree_; }
  const std::vector<R>& q() const { return q_; }
  const R& tilt() const { return tilt_; }

  /// The power of the traction at point j, with its exact form; zero where Y has none.
  const Exponent& exponent(std::size_t j) const;
  std::size_t slope_at(std::size_t segment) const { return problem_->slope_of(set_.interval(segment)); }
  std::size_t friction_at(std::size_t segment) const { return problem_->friction_of(set_.interval(segment)); }
  /// eps on a segment in contact; the sign of Y on any other, -1 and the number of segments included.
  int sign(std::ptrdiff_t segment) const { return signs_[static_cast<std::size_t>(segment + 1)]; }

  /// B_k, with what rounding may have done to it.
  Estimate<R> bracket(std::size_t slope, const SurfacePoint<R>& at) const;
  /// B_k at point j of the set, k the slope on that side; where the contact changes its polynomial at j, what is left
  /// of B_k without its singular term there (a multiple of |x - x_j|^-p, or of log|x - x_j| where p = 0).
  Estimate<R> bracket_at(std::size_t j, Side side) const;
  R modulus(const SurfacePoint<R>& at) const;
  /// t; zero off the contact.
  Estimate<R> traction(const SurfacePoint<R>& at) const;
  /// Does the profile change its polynomial at j, within the contact?
  bool is_kinked(std::size_t j) const;
  /// int t over a segment in contact whose two points are not kinked.
  Estimate<R> load_on(std::size_t segment) const;
  /// -int xi t.
  R moment_of_load() const;
  /// The reduced slope u'/c.
  Estimate<R> surface_slope(const SurfacePoint<R>& at) const;
  /// Reduced gap at a point off the contact, measured from the contact end j, which faces it. Throws std::domain_error
  /// off the support, where there is no indenter.
  Estimate<R> opening(std::size_t j, const SurfacePoint<R>& at) const;

  /// The tilted profile's height at a point off the contact minus that at contact end j, on the side of the contact.
  R profile_rise(std::size_t j, const SurfacePoint<R>& at) const;

  /// Where the tilted profile over a segment has its valleys and peaks: the first places to look for contact, however
  /// small they are beside the segment.
  std::vector<SurfacePoint<R>> extremes(std::size_t segment) const;

  // What Newton's method asks for.
  /// c_i of 1/Y = z^-S (1 + c_1/z + ...), d_i of Y = z^S (1 + d_1/z + ...).
  const std::vector<R>& inverse_series() const { return inverse_series_; }
  const std::vector<R>& series() const { return series_; }
  /// m_j of u'/(c Y) = m_0/z + m_1/z^2 + ..., plus the polynomial q/pi.
  std::vector<R> moments(std::size_t count) const;
  /// The coefficient of z^-1-j of 1/Y: what the tilt adds to m_j.
  R tilt_moment(std::size_t j) const;
  /// [1/Y]_poly at x.
  R tilt_polynomial(const R& x) const;

  /// A rule for integrals over the gap that begins at point j: functions like Y/(x - e) at its ends.
  struct GapNode {
    SurfacePoint<R> at;
    std::size_t slope;  ///< the k in use
    R weight;
    R y;  ///< Y, with its sign
  };
  std::vector<GapNode> gap_rule(std::size_t j) const;
  /// The height that the profile misses at the far end of the gap that begins at j: zero for a solution.
  R closure(std::size_t j, const std::vector<GapNode>& rule) const;
  /// x - x_j.
  R distance(const SurfacePoint<R>& at, std::size_t j) const;

 private:
  /// Part of a segment: what lies left of it, its length, and what lies right of it; zeros are exact.
  struct Stretch {
    R from_left;
    R length;
    R from_right;
  };
  /// A part of a segment with its rule, whose nodes count from the end where the power sits.
  struct Part {
    std::size_t segment;
    R from_left;   ///< of the segment's left end
    R from_right;  ///< of its right end
    R length;
    std::optional<Side> singular_end;
    Power<R> power;
    const JacobiRule<R>* rule;

    SurfacePoint<R> node(const ContactSet<R>& set, std::size_t i) const;
    /// int f dxi = sum of node_weight(i) f(node(i)), for f = distance^power times a smooth function.
    R node_weight(std::size_t i) const;
  };
  struct ContactPanel {
    Part part;
    std::size_t first;  ///< of its nodes
  };

  static Power<R> power_of(const ReducedProblem<R>& problem, const ContactSet<R>& set, std::size_t j);
  static FundamentalSolution<R> make_weight(const ReducedProblem<R>& problem, const ContactSet<R>& set);
  void find_signs();
  void expand_at_infinity();
  void make_panels();
  int nodes_per_panel() const;
  /// A part of a segment cut into parts for the rules; `power_of(j)` is the integrand's power at point j.
  std::vector<Part> parts(std::size_t segment, const Stretch& stretch, Surroundings<R> around, int nodes,
                          const std::function<Power<R>(std::size_t)>& power_of) const;
  /// Coefficients of [(g_k + tilt)/Y]_poly - q/pi.
  const std::vector<R>& polynomial(std::size_t slope) const;
  /// eps cos(pi alpha) (g - g_k)/|Y| times the rule's weight, at every node of the contact.
  const std::vector<R>& density(std::size_t slope) const;
  Estimate<R> cauchy(std::size_t slope, const SurfacePoint<R>& at) const;
  Estimate<R> panel_cauchy(const ContactPanel& panel, std::size_t slope, const SurfacePoint<R>& at, const R& between,
                           const std::vector<R>& density) const;
  Surroundings<R> surroundings(std::size_t segment, bool gap) const;
  bool is_singular(std::size_t j, bool gap) const;
  Stretch whole(std::size_t segment) const { return {R(0), set_.length(segment), R(0)}; }
  void add_gap_nodes(std::size_t segment, const Stretch& stretch, std::vector<GapNode>& nodes) const;
  void add_gap_nodes(std::size_t segment, const Stretch& stretch, std::size_t slope, std::vector<GapNode>& nodes) const;
  bool changes_slope(std::size_t segment) const;
  std::size_t slope_for_gap(std::size_t segment, bool left_half) const;
  R rate(const GapNode& node) const;
  /// int (profile slope - g_k) over a part of a gap segment, k as the gap's nodes use it.
  R slope_difference(std::size_t segment, const R& from, const R& length) const;

  const ReducedProblem<R>* problem_;
  JacobiRules<R>* rules_;
  ContactSet<R> set_;
  FundamentalSolution<R> weight_;
  std::vector<R> q_;
  R tilt_;
  int degree_ = 0;
  std::vector<int> signs_;
  std::vector<R> series_;
  std::vector<R> inverse_series_;
  std::vector<ContactPanel> panels_;      ///< empty where one polynomial rules
  std::vector<std::size_t> first_panel_;  ///< of each segment, and one more
  std::vector<SurfacePoint<R>> nodes_;
  std::vector<R> node_weights_;
  mutable std::vector<std::vector<R>> polynomials_;
  mutable std::vector<std::vector<R>> densities_;
};

}  // namespace steadyslide::numeric
