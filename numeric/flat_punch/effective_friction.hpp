#pragma once
// The effective friction of a flat punch in full contact under any strips, as an integral over the free surface:
//
//   s_eff = -int s t dx / P = (1/pi) int_1^oo [e^A - e^-B] dx/sqrt(x^2-1),
//   A(x) = int_-1^1 alpha(y) dy/(x+y),   B(x) = int_-1^1 alpha(y) dy/(x-y),   alpha = arctan(s)/pi.
//
// Derivation, P = 1, t = -t_0 with A t_0 = 0: int s t_0 = -int_-1^1 H t_0, H t_0 = (1/pi) PV int t_0(x')/(x'-x) dx'. Over
// the whole line int H t_0 = 0 in the sense lim int_-L^L, since H t_0 ~ -1/(pi x). So s_eff = int H t_0 over |x| > 1, where
// H t_0 = -Y/pi; and log |Y| = -log(x^2-1)/2 + sum of beta_j log|x - c_j| and the ends' alphas, by parts -B to the right
// of the punch and A to the left of it. With s = +-gamma f the effective coefficient of friction is s_eff/(+-gamma).
//
// e^A grows and e^-B falls with alpha at each place: s_eff is increasing in alpha, its derivative
//
//   w(y) = (1/pi) int_1^oo [e^A/(x+y) + e^-B/(x-y)] dx/sqrt(x^2-1) > 0,
//
// strictly convex in y, infinite at both ends. Sliding the other way turns all signs of alpha:
//
//   s_eff(alpha) + s_eff(-alpha) = (2/pi) int_1^oo (cosh A - cosh B) dx/sqrt(x^2-1).
//
// Two equal halves have A - B = (alpha_1 - alpha_2) log(x^2/(x^2-1)) and A + B = (alpha_1 + alpha_2) log((x+1)/(x-1)): the rougher
// one at the rear has more friction, whatever s >= 0. To first order it is (4 G/pi^2) (s_1^2 - s_2^2), G Catalan's constant.
//
// Computed by the trapezoidal rule in log(x-1): all singular points of the integrand lie on Im = +-pi, wherever friction
// jumps, so that the error falls like e^(-2 pi^2/h) for every layout. What is left of the first and right of the last node
// are geometric series, which are summed. No term of s_eff or w cancels another where s has one sign.

#include "numeric/flat_punch/friction_layout.hpp"
#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

template <Real R>
class EffectiveFriction {
 public:
  explicit EffectiveFriction(FrictionLayout<R> layout);

  /// s_eff, with the sign of s. Divided by gamma (its sign that of sliding) the effective friction.
  Estimate<R> value() const;
  /// s_eff(alpha) + s_eff(-alpha): for s >= 0 what sliding towards +x costs more than sliding towards -x.
  Estimate<R> direction_difference() const;
  /// w at a place, by its distances from the ends of the punch in the layout's unit, both > 0; w is for y, whatever
  /// that unit is.
  Estimate<R> derivative(const R& from_left, const R& from_right) const;

 private:
  struct Node {
    R d;       ///< x - 1, in the layout's unit
    R weight;  ///< of the rule, times (1/pi) dx/sqrt(x^2-1)
    R a;       ///< A
    R b;
    R exp_a;        ///< e^A
    R exp_minus_b;  ///< e^-B
  };
  /// What the nodes left of the first one would add to a sum, if the terms there are `first` times d^power.
  R left_tail(const R& first, const R& power) const;
  /// Relative, of rounding: a power d^-alpha is an exponential.
  R relative_error() const;

  FrictionLayout<R> layout_;
  R step_;
  std::vector<Node> nodes_;
};

}  // namespace steadyslide::numeric
