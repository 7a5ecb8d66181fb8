#pragma once
// Tractions t = (1+x)^left (1-x)^right factor(x) on ]-1, 1[, factor a polynomial, and the form
//
//   b(t, t_hat) = int t v dx,   v(y) = int t_hat(x) (-(1/pi) log|x-y| + (s/2) sgn(x-y)) dx.
//
// v has a closed form. For t_hat = T_k/sqrt(1-x^2), y = cos theta, k >= 1 it is
//
//   v = (cos(k theta) + s sin(k theta))/k = (T_k(y) + s U_{k-1}(y) sqrt(1-y^2))/k,
//
// and Gauss-Jacobi rules integrate t v without error. For t_hat = x^m it consists of elementary functions.
// [Bal16, section 3.1]

#include <vector>

#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

template <class R>
struct JacobiTraction {
  numeric::Power<R> left;
  numeric::Power<R> right;
  std::vector<R> factor;  ///< coefficients of 1, x, x^2, ...
};

template <class R>
PanelDensity<R> density_of(const JacobiTraction<R>& t);
/// Returns int t by tanh-sinh.
template <class R>
R integral(const JacobiTraction<R>& t);
/// Returns b(t, T_k/sqrt(1-x^2)), k >= 1.
template <class R>
R form_with_chebyshev(const JacobiTraction<R>& t, const R& s, int k);
/// Returns b(t, x^m) by tanh-sinh.
template <class R>
R form_with_power(const JacobiTraction<R>& t, const R& s, int m);

}  // namespace steadyslide::proofs_checks
