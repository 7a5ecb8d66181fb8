#pragma once
// The forms of section 3.1 on tractions t with t dx = cos(k theta) dtheta, x = (L/2) cos theta: T_k/sqrt(1-x^2) where
// L = 2. By quadrature in both angles: the log and the sign function are evaluated at the distance of the places and
// nothing else is known of them.
//
//   log_form(j, k) = -int_0^pi int_0^pi cos(j phi) cos(k theta) log|x(phi) - x(theta)| dtheta dphi,
//   sign_form(j, k) = <<t_j * sgn, t_k>> = int int cos(j theta) cos(k phi) sgn(x(phi) - x(theta)) dtheta dphi.
//
// The inner integrals are cut where the angles meet: a double-exponential rule for the logarithm, Gauss' for the sign.
// The outer one is the midpoint rule for the first (what it integrates is a trigonometric polynomial), Gauss' for the
// second. [Bal16, section 3.1]

#include <vector>

#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

/// j, k = 0, ..., highest_angle.
template <class R>
using FormMatrix = std::vector<std::vector<R>>;
inline constexpr int highest_angle = 4;

template <class R>
FormMatrix<R> log_form_by_quadrature(const R& length);
/// Made once.
template <class R>
const FormMatrix<R>& sign_form_by_quadrature();

/// sum_jk c_j M_jk d_k.
template <class R>
R value_of(const FormMatrix<R>& form, const std::vector<R>& c, const std::vector<R>& d) {
  R sum = 0;
  for (std::size_t j = 0; j < c.size(); ++j) {
    for (std::size_t k = 0; k < d.size(); ++k) sum += c[j] * form[j][k] * d[k];
  }
  return sum;
}

}  // namespace steadyslide::proofs_checks
