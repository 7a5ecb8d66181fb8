#pragma once
// Polynomials with balls as coefficients of 1, x, x^2, ...

#include <span>
#include <vector>

#include "enclosure/number/ball.hpp"
#include "model/polynomial.hpp"

namespace steadyslide::enclosure {

using BallPolynomial = std::vector<Ball>;

BallPolynomial in_balls(const Polynomial& polynomial, Bits bits);
Ball value_at(const BallPolynomial& polynomial, const Ball& x);
/// Returns an upper bound of |p(x)| for |x| <= radius, at the radius' precision.
Ball bound_within(const BallPolynomial& polynomial, const Ball& radius);
/// Adds sum_i weights_i points_i^k to moments_k, for every k.
void add_moments(std::span<Ball> moments, const std::vector<Ball>& weights, const std::vector<Ball>& points);
/// Returns int_x^{x+length} p, computed from the derivatives at x, so that a short interval loses no digits.
Ball integral_over(BallPolynomial polynomial, const Ball& x, const Ball& length);
BallPolynomial product(const BallPolynomial& a, const BallPolynomial& b);
/// Returns the coefficients of powers of x - c.
BallPolynomial shifted(BallPolynomial polynomial, const Ball& c);
/// Returns p(z)/(z - e) without its remainder.
BallPolynomial quotient(const BallPolynomial& polynomial, const Ball& e);

}  // namespace steadyslide::enclosure
