#pragma once
// The part of the load left of the only friction jump under a flat punch in full contact, c = -1 + 2 u in y of
// friction_layout.hpp:
//
//   -int_-1^c t dx / P = I_u(1/2 - alpha_+, 1/2 + alpha_-),   I the regularised incomplete beta function.
//
// Derivation: v = (c-x)/(1-x) turns the integral of t_0 into cos(pi alpha_-)/pi (1-u)^(1/2+alpha_-) u^(1/2-alpha_+) B(1+beta,
// 1/2-alpha_-) F(1, 1+beta; 3/2-alpha_+; u), F Gauss' function, beta = alpha_- - alpha_+; that is the series of I_u(a, b) = u^a (1-u)^b
// F(1, a+b; a+1; u)/(a B(a,b)), with Gamma(1/2-alpha_-) Gamma(1/2+alpha_-) = pi/cos(pi alpha_-).

#include "model/rational.hpp"
#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

/// `u`, 0 < u < 1: the part of the contact's length left of the jump.
template <Real R>
Estimate<R> rear_share(const Rational& s_left, const Rational& s_right, const Rational& u);

}  // namespace steadyslide::numeric
