#pragma once
// The forms of section 3.1 on tractions t with t dx = cos(k theta) dtheta, x = (L/2) cos theta; for L = 2 these are
// T_k/sqrt(1-x^2). Computed by quadrature in both angles: the logarithm and the sign function are evaluated at the
// distance of two points, and nothing else about them is used.
//
//   log_form(j, k) = -int_0^pi int_0^pi cos(j phi) cos(k theta) log|x(phi) - x(theta)| dtheta dphi,
//   sign_form(j, k) = <<t_j * sgn, t_k>> = int int cos(j theta) cos(k phi) sgn(x(phi) - x(theta)) dtheta dphi.
//
// The inner integrals are divided at the angle at which the two points coincide. They use a double-exponential rule for
// the logarithm and Gauss' rule for the sign. The outer integral of the first form uses the midpoint rule, because its
// integrand is a trigonometric polynomial. That of the second form uses Gauss' rule. [Bal16, section 3.1]

#include <vector>

#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

/// The values of a form for j, k = 0, ..., highest_angle.
template <class R>
using FormMatrix = std::vector<std::vector<R>>;
inline constexpr int highest_angle = 4;

template <class R>
FormMatrix<R> log_form_by_quadrature(const R& length);
/// Returns the form, which is computed once.
template <class R>
const FormMatrix<R>& sign_form_by_quadrature();

/// Returns sum_jk c_j M_jk d_k.
template <class R>
R value_of(const FormMatrix<R>& form, const std::vector<R>& c, const std::vector<R>& d) {
  R sum = 0;
  for (std::size_t j = 0; j < c.size(); ++j) {
    for (std::size_t k = 0; k < d.size(); ++k) sum += c[j] * form[j][k] * d[k];
  }
  return sum;
}

}  // namespace steadyslide::proofs_checks
