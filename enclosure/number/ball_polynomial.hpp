#pragma once
// Polynomials with balls for coefficients: those of 1, x, x^2, ...

#include <span>
#include <vector>

#include "enclosure/number/ball.hpp"
#include "model/polynomial.hpp"

namespace steadyslide::enclosure {

using BallPolynomial = std::vector<Ball>;

BallPolynomial in_balls(const Polynomial& polynomial, Bits bits);
Ball value_at(const BallPolynomial& polynomial, const Ball& x);
/// |p(x)| is no larger for |x| <= radius, at the radius' precision.
Ball bound_within(const BallPolynomial& polynomial, const Ball& radius);
/// Adds sum_i weights_i points_i^k to moments_k, for every k.
void add_moments(std::span<Ball> moments, const std::vector<Ball>& weights, const std::vector<Ball>& points);
/// int_x^{x+length} p: from the derivatives at x, so that a short interval loses nothing.
Ball integral_over(BallPolynomial polynomial, const Ball& x, const Ball& length);
BallPolynomial product(const BallPolynomial& a, const BallPolynomial& b);
/// The coefficients of powers of x - c.
BallPolynomial shifted(BallPolynomial polynomial, const Ball& c);
/// p(z)/(z - e) without its remainder.
BallPolynomial quotient(const BallPolynomial& polynomial, const Ball& e);

}  // namespace steadyslide::enclosure
