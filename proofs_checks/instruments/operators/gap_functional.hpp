#pragma once
// What the functional phi of [Bal16, (13)] is made of, on functions v = u_hat - psi that are polynomials of degree <= 3
// on each of a few panels of [-1, 1]:
//
//   phi = inf { <-P t_0, v + C> : v + C <= 0 } = <P t_0, ess sup v - v>,
//   t_0 = (cos(pi alpha)/pi) (1+x)^{-(1/2+alpha)} (1-x)^{-(1/2-alpha)}.
//
// Functions are exact, integrals against t_0 by quadrature.

#include <vector>

#include "model/polynomial.hpp"
#include "proofs_checks/kit/numbers.hpp"
#include "proofs_checks/kit/random.hpp"

namespace steadyslide::proofs_checks {

/// May jump where panels meet; random functions do not.
struct PiecewiseFunction {
  std::vector<Rational> points;  ///< -1, ..., 1
  std::vector<Polynomial> pieces;

  static PiecewiseFunction constant(const Rational& value, std::vector<Rational> points = {-1, 1});
  /// a f + b g, on the same points.
  static PiecewiseFunction combined(const Rational& a, const PiecewiseFunction& f, const Rational& b,
                                    const PiecewiseFunction& g);
  Rational at(const Rational& x) const;
};

/// Continuous, linear on each panel.
PiecewiseFunction random_polygon(Random& random, const std::vector<Rational>& points);
PiecewiseFunction random_cubic(Random& random);
/// -1, one to three multiples of 1/8, 1.
std::vector<Rational> random_points(Random& random);

/// max v by ends of panels and zeros of derivatives.
template <Real R>
R supremum(const PiecewiseFunction& v);
/// The largest C with v + C <= 0 everywhere, by bisection over C; whether C is allowed is decided by the signs of
/// Bernstein's coefficients on ever shorter intervals.
template <Real R>
R largest_shift(const PiecewiseFunction& v);

/// int t_0 v by Gauss-Jacobi rules, t_0 of the friction s.
template <Real R>
R pairing(const Rational& s, const PiecewiseFunction& v);
/// The same by tanh-sinh.
template <Real R>
R pairing_by_tanh_sinh(const Rational& s, const PiecewiseFunction& v);
/// The same for one polynomial: int x^k t_0 by (k+1) m_{k+1} = k m_{k-1} - 2 alpha m_k.
template <Real R>
R pairing_by_moments(const Rational& s, const Polynomial& v);

}  // namespace steadyslide::proofs_checks
