#pragma once
// The parts of the functional phi of [Bal16, (13)], for functions v = u_hat - psi that are polynomials of degree <= 3
// on each of a few panels of [-1, 1]:
//
//   phi = inf { <-P t_0, v + C> : v + C <= 0 } = <P t_0, ess sup v - v>,
//   t_0 = (cos(pi alpha)/pi) (1+x)^{-(1/2+alpha)} (1-x)^{-(1/2-alpha)}.
//
// The functions are exact. The integrals against t_0 are computed by quadrature.

#include <vector>

#include "model/polynomial.hpp"
#include "proofs_checks/kit/numbers.hpp"
#include "proofs_checks/kit/random.hpp"

namespace steadyslide::proofs_checks {

/// A function on panels. It may jump between panels; random functions do not.
struct PiecewiseFunction {
  std::vector<Rational> points;  ///< the ends of the panels: -1, ..., 1
  std::vector<Polynomial> pieces;

  static PiecewiseFunction constant(const Rational& value, std::vector<Rational> points = {-1, 1});
  /// Returns a f + b g, where f and g have the same points.
  static PiecewiseFunction combined(const Rational& a, const PiecewiseFunction& f, const Rational& b,
                                    const PiecewiseFunction& g);
  Rational at(const Rational& x) const;
};

/// Returns a continuous function that is linear on each panel.
PiecewiseFunction random_polygon(Random& random, const std::vector<Rational>& points);
PiecewiseFunction random_cubic(Random& random);
/// Returns -1, one to three multiples of 1/8, and 1.
std::vector<Rational> random_points(Random& random);

/// Returns max v from the ends of panels and the zeros of derivatives.
template <Real R>
R supremum(const PiecewiseFunction& v);
/// Returns the largest C with v + C <= 0 everywhere, by bisection. The signs of Bernstein's coefficients on shorter and
/// shorter intervals decide if a value of C is admissible.
template <Real R>
R largest_shift(const PiecewiseFunction& v);

/// Returns int t_0 v by Gauss-Jacobi rules, with t_0 for the friction s.
template <Real R>
R pairing(const Rational& s, const PiecewiseFunction& v);
/// Returns the same integral by tanh-sinh.
template <Real R>
R pairing_by_tanh_sinh(const Rational& s, const PiecewiseFunction& v);
/// Returns the same integral for one polynomial. The moments m_k = int x^k t_0 have the recurrence
/// (k+1) m_{k+1} = k m_{k-1} - 2 alpha m_k.
template <Real R>
R pairing_by_moments(const Rational& s, const Polynomial& v);

}  // namespace steadyslide::proofs_checks
