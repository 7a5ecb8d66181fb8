#pragma once
// A flat punch in full contact, by integrals over the free surface or of the friction angle. The traction is not
// needed.

#include <optional>
#include <vector>

#include "model/contact_problem.hpp"
#include "model/rational.hpp"
#include "numeric/number/estimate.hpp"
#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

// The friction under a flat punch in full contact: strips from left to right, each with one s = +-gamma f. Results do
// not depend on the unit of length. The coordinate y is -1 at the left end and 1 at the right end:
//
//   alpha = arctan(s)/pi,   M_j = int_-1^1 y^j alpha(y) dy.
//
// Centre of pressure: y = -M_0. (u'/c = -(P/pi) Y beside the punch, and Y = exp(-int alpha dy/(x-y))/sqrt(x^2-1) =
// 1/x - M_0/x^2 + ..., while the Cauchy integral of t gives load and moment in these two places.)

template <Real R>
struct FrictionStrip {
  R length;
  R from_left;   ///< from the punch's left end to the strip's left end
  R from_right;  ///< from the strip's right end to the punch's right end
  R alpha;
  R below_half;  ///< 1/2 - alpha, to full relative precision for any friction
  R above_half;  ///< 1/2 + alpha
};

template <Real R>
class FrictionLayout {
 public:
  /// Takes one length > 0, as accurate as possible, for each s. Throws std::invalid_argument otherwise.
  FrictionLayout(const std::vector<R>& lengths, const std::vector<Rational>& s);
  /// Returns the strips under the whole support.
  static FrictionLayout of(const ContactProblem& problem);
  /// Returns the same strips repeated `periods` times. `shares` are parts of a period; their sum is 1.
  static FrictionLayout periodic(const std::vector<Rational>& shares, const std::vector<Rational>& s, int periods);

  const std::vector<FrictionStrip<R>>& strips() const { return strips_; }
  const R& length() const { return length_; }
  /// Returns M_0 or M_1.
  R moment(int j) const;
  /// Returns y of a strip's middle.
  R middle(const FrictionStrip<R>& strip) const { return (strip.from_left - strip.from_right) / length_; }

 private:
  std::vector<FrictionStrip<R>> strips_;
  R length_ = 0;
};

// The effective friction of a flat punch in full contact under any strips, as an integral over the free surface:
//
//   s_eff = -int s t dx / P = (1/pi) int_1^oo [e^A - e^-B] dx/sqrt(x^2-1),
//   A(x) = int_-1^1 alpha(y) dy/(x+y),   B(x) = int_-1^1 alpha(y) dy/(x-y),   alpha = arctan(s)/pi.
//
// Derivation, P = 1, t = -t_0 with A t_0 = 0: int s t_0 = -int_-1^1 H t_0, H t_0 = (1/pi) PV int t_0(x')/(x'-x) dx'.
// Over the whole line int H t_0 = 0 in the sense lim int_-L^L, since H t_0 ~ -1/(pi x). So s_eff = int H t_0 over
// |x| > 1, where H t_0 = -Y/pi; and log |Y| = -log(x^2-1)/2 + sum of beta_j log|x - c_j| and the ends' alphas, by parts
// -B to the right of the punch and A to the left of it. With s = +-gamma f the effective coefficient of friction is
// s_eff/(+-gamma).
//
// e^A grows and e^-B falls with alpha at each place: s_eff is increasing in alpha, its derivative
//
//   w(y) = (1/pi) int_1^oo [e^A/(x+y) + e^-B/(x-y)] dx/sqrt(x^2-1) > 0,
//
// strictly convex in y, infinite at both ends. Sliding in the opposite direction changes all signs of alpha:
//
//   s_eff(alpha) + s_eff(-alpha) = (2/pi) int_1^oo (cosh A - cosh B) dx/sqrt(x^2-1).
//
// Two equal halves have A - B = (alpha_1 - alpha_2) log(x^2/(x^2-1)) and A + B = (alpha_1 + alpha_2) log((x+1)/(x-1)):
// with the rougher half at the rear the friction is larger, for all s >= 0. To first order it is (4 G/pi^2)
// (s_1^2 - s_2^2), G Catalan's constant.
//
// Computed by the trapezoidal rule in log(x-1). All singular points of the integrand lie on Im = +-pi, for any
// positions of the friction jumps, so the error decreases like e^(-2 pi^2/h) for every layout. The terms left of the
// first node and right of the last node are geometric series, which are summed. If s has one sign, the terms of s_eff
// and w do not cancel.

template <Real R>
class EffectiveFriction {
 public:
  explicit EffectiveFriction(FrictionLayout<R> layout);

  /// Returns s_eff, with the sign of s. Divided by gamma, with the sign of the sliding direction, it is the effective
  /// friction.
  Estimate<R> value() const;
  /// Returns s_eff(alpha) + s_eff(-alpha): for s >= 0, the friction for sliding towards +x minus that for sliding
  /// towards -x.
  Estimate<R> direction_difference() const;
  /// Returns w at a place, given by its distances from the ends of the punch in the layout's unit, both > 0. The
  /// derivative is with respect to alpha(y) dy, for any unit of the layout.
  Estimate<R> derivative(const R& from_left, const R& from_right) const;

 private:
  struct Node {
    R d;       ///< x - 1, in the layout's unit
    R weight;  ///< weight of the rule, times (1/pi) dx/sqrt(x^2-1)
    R a;       ///< A
    R b;
    R exp_a;        ///< e^A
    R exp_minus_b;  ///< e^-B
  };
  /// Returns the sum over the nodes left of the first one, if their terms are `first` times d^power.
  R left_tail(const R& first, const R& power) const;
  /// Returns the relative rounding error: a power d^-alpha is an exponential.
  R relative_error() const;

  FrictionLayout<R> layout_;
  R step_;
  std::vector<Node> nodes_;
};

// The layout of two coatings with given shares of the contact for which a flat punch has the largest or the smallest
// friction. It is never inner | outer, but always outer | inner | outer with two jumps,
//
//   largest: the coating of larger alpha outside, smallest: inside,   w(first jump) = w(second jump).
//
// Proof: among all mixtures 0 <= share(y) <= 1 of both coatings s_eff has a largest value (the set is weak-* compact,
// s_eff is continuous on it). There no admissible change increases s_eff: int w (alpha - alpha*) <= 0. So alpha* is
// largest where w is largest (bathtub principle). w is strictly convex with infinite limits at both ends: {w < const}
// is an interval strictly inside. Smallest: the same with opposite signs.
// The place of the interval solves a strictly concave problem (convex for the smallest): with D the difference of the
// alphas, 0 < D < 1, phi half the length of the interval and c its centre, c enters by h(z) = ((z-phi)/(z+phi))^D,
// z = x+c in e^A and, inverted, z = x-c in e^-B, and
//   h'' = 4 D phi (D phi - z)/(z^2-phi^2)^2 h < 0,   (1/h)'' > 0   for z > phi.
// So the difference of w at the two jumps decreases as c grows, and has only one zero.

template <Real R>
struct ExtremeLayout {
  Estimate<R> left;   ///< the length of the first strip, for a contact of length 1
  Estimate<R> right;  ///< the length of the last strip
  FrictionLayout<R> layout;
  Estimate<R> s_eff;
};

/// Returns the layout with the largest s_eff if s_outer > s_inner, otherwise the layout with the smallest. Both signs
/// are allowed. Throws std::invalid_argument unless they differ and 0 < inner_share < 1. Throws std::range_error if a
/// strip is shorter than 1e-200 of the contact; this needs large friction and an inner share close to 1.
template <Real R>
ExtremeLayout<R> extreme_layout(const Rational& s_outer, const Rational& s_inner, const Rational& inner_share);

// If the coatings alternate faster and faster, the friction of a flat punch tends to a limit: A and B of
// EffectiveFriction are integrals of alpha times fixed functions, so that only the mean of alpha remains,
//
//   s_eff -> tan(pi <alpha>),   for s >= 0 at most the mean of s (Jensen: tan is convex there).
//
// The convergence with N periods is slow: next to the rear end, at distances d of a period, A differs from its limit by
// a number, and this region contributes int_0^(1/N) d^(-1/2 - <alpha>) dd to the integral; at the front end the same
// with +<alpha>. Sliding towards +x
//
//   s_eff(N) - s_eff(oo) ~ C N^-(1/2 - <alpha>),
//
// C has the sign of the outermost coating: if it is rougher than the mean, the friction is larger. The term of the
// front end, N^-(1/2 + <alpha>), is next. If <alpha> is small, both terms must be separated before an order can be
// measured.

template <Real R>
struct FineMixture {
  Estimate<R> s_eff;  ///< tan(pi <alpha>)
  R order;            ///< 1/2 - |<alpha>|: the order of convergence in 1/N for N periods
};

/// Takes shares of the contact, whose sum is 1, and s for each share.
template <Real R>
FineMixture<R> fine_mixture(const std::vector<Rational>& shares, const std::vector<Rational>& s);

/// Returns the smaller order p in e(N) = C N^-p + D N^-(1-p), from e(N), e(2N) and e(4N): 2^-p and 2^-(1-p) have the
/// product 1/2 and the sum (e(4N) + e(N)/2)/e(2N).
template <Real R>
R order_of_periods(const R& e, const R& doubled, const R& doubled_twice);

// The core of the contact, defined like the core of a column's cross-section: if the load acts there, a flat punch that
// may tilt stays in full contact. In y of FrictionLayout, with M_j defined there, the core is
//
//   from M_1/(1+M_0) - (1+M_0)/2 to (1-M_0)/2 - M_1/(1-M_0);   without friction from -1/2 to 1/2.
//
// Derivation: a slope k of the punch adds a multiple of (1/Y) without its part that falls at infinity, and
// 1/Y = x + M_0 + ...: t = -t_0 (P + k (x + M_0)), int t = -P for every k. It is <= 0 all over if P + k (1 + M_0) >= 0
// and P - k (1 - M_0) >= 0. The load acts at -M_0 + (k/P) V, V the variance of t_0:
// Y = 1/x - M_0/x^2 + (1/2 + M_0^2/2 - M_1)/x^3 has the moments of t_0, so V = (1 - M_0^2)/2 - M_1, and the two bounds
// of k give the two ends. In other words: the right end is the centroid of 1/2 - alpha plus half its integral, the left
// end that of 1/2 + alpha minus half its integral. Nothing cancels for large s.

template <Real R>
struct PunchCore {
  Estimate<R> left;
  Estimate<R> right;
};

/// Returns the core in the user's x. It does not depend on the load. Absent unless the punch is rigid and its profile
/// is constant.
template <Real R>
std::optional<PunchCore<R>> punch_core(const ContactProblem& problem);

// The load share left of the only friction jump under a flat punch in full contact, with c = -1 + 2 u in y of
// FrictionLayout:
//
//   -int_-1^c t dx / P = I_u(1/2 - alpha_+, 1/2 + alpha_-),   I the regularised incomplete beta function.
//
// Derivation: v = (c-x)/(1-x) turns the integral of t_0 into cos(pi alpha_-)/pi (1-u)^(1/2+alpha_-) u^(1/2-alpha_+)
// B(1+beta, 1/2-alpha_-) F(1, 1+beta; 3/2-alpha_+; u), F Gauss' function, beta = alpha_- - alpha_+; that is the series
// of I_u(a, b) = u^a (1-u)^b F(1, a+b; a+1; u)/(a B(a,b)), with Gamma(1/2-alpha_-) Gamma(1/2+alpha_-) = pi/cos(pi
// alpha_-).

/// `u`, 0 < u < 1, is the share of the contact's length left of the jump.
template <Real R>
Estimate<R> rear_share(const Rational& s_left, const Rational& s_right, const Rational& u);

}  // namespace steadyslide::numeric
