#pragma once
// The effect of forces n_i at x_i on the surface at a point (x, z). With X = x - x_i, d^2 = X^2 + z^2, the sums
//
//   M_j = sum_i n_i X^j z^(3-j)/d^4,   j = 0, ..., 3,
//
// of normal and tangential forces give the stresses (half_plane_stress.hpp) and the rotation of the body:
//
//   normal:       (pi/2) (xx, zz, xz) = (M_2, M_0, M_1),      pi W = M_1 + M_3,
//   tangential:   (pi/2) (xx, zz, xz) = -(M_3, M_1, M_2),     pi W = M_0 + M_2,
//
// W = Im C_t - Re C, which is (d u_z/dx - d u_x/dz)/(2 c), c the half-space's compliance (kappa + 1)/(4 mu): by the
// equations of equilibrium (kappa + 1)/4 (sigma_xx + sigma_zz) and 2 mu times the rotation are the real and the
// imaginary part of one function of x + iz, and sigma_xx + sigma_zz = 2 Im C + 2 Re C_t. It vanishes far away.
//
// Many forces around c, |x_i - c| <= h, are represented by their moments m_k = sum_i n_i ((x_i - c)/h)^k. Since
// 1/(1 - 2 q s + s^2)^2 = sum_k C_k(q) s^k with Gegenbauer's polynomials C_k of index 2, at a distance D >= 3 h with
// q = (x - c)/D
//
//   M_j = (z/D)^(3-j)/D sum_i n_i (q - s_i)^j sum_k C_k(q) s_i^k,   s_i = (x_i - c)/D:
//
// small stresses under a free surface keep their digits. Since |C_k| <= (k+1)(k+2)(k+3)/6, the omitted terms are below
// k^3/4 3^-k sum |n_i|/D.

#include <array>
#include <cmath>
#include <vector>

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

/// M_0 to M_3 of the normal and of the tangential forces, and their errors.
template <Real R>
struct ForceSums {
  std::array<R, 4> normal{};
  std::array<R, 4> tangential{};
  std::array<R, 4> normal_error{};
  std::array<R, 4> tangential_error{};
};

/// Adds a force.
template <Real R>
void add_force(std::array<R, 4>& sums, const R& force, const R& x, const R& z) {
  const R inverse = 1 / (x * x + z * z);
  const R a = x * inverse;
  const R b = z * inverse;
  const R zz = force * (z * b);
  const R xx = force * (x * a);
  sums[0] += b * zz;
  sums[1] += a * zz;
  sums[2] += b * xx;
  sums[3] += a * xx;
}

/// The number of moments for which the sums are accurate to epsilon.
template <Real R>
std::size_t moment_count() {
  static const std::size_t count = static_cast<std::size_t>(static_cast<int>(-log(epsilon<R>()) / log(R(3)))) + 16;
  return count;
}

/// Computes moments about c from moments about c', with `scale` = h'/h and `shift` = (c' - c)/h.
template <Real R>
void add_moments(const R* from, const R& scale, const R& shift, R* to) {
  std::vector<R> moments(from, from + moment_count<R>());
  R power = scale;
  for (std::size_t k = 1; k < moments.size(); ++k, power *= scale) moments[k] *= power;
  // Computes the moments of (u + shift)^k from the moments of u^k.
  for (std::size_t pass = 1; pass < moments.size(); ++pass) {
    for (std::size_t k = moments.size() - 1; k >= pass; --k) moments[k] += shift * moments[k - 1];
  }
  for (std::size_t k = 0; k < moments.size(); ++k) to[k] += moments[k];
}

/// Adds forces with these moments. (x, z) is relative to c.
template <Real R>
void add_far_forces(ForceSums<R>& sums, const R* normal, const R* tangential, const R& h, const R& x, const R& z) {
  const std::size_t count = moment_count<R>() - 3;
  const R distance = sqrt(x * x + z * z);
  const R q = x / distance;
  const R ratio = h / distance;
  std::array<R, 4> n{};
  std::array<R, 4> t{};
  R before = 0;  // C_k-1 ratio^k-1
  R now = 1;
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t l = 0; l < 4; ++l) {
      n[l] += now * normal[k + l];
      t[l] += now * tangential[k + l];
    }
    const auto order = static_cast<double>(k + 1);
    const R next = ratio * (2 * (order + 1) * q * now - (order + 2) * ratio * before) / order;
    before = now;
    now = next;
  }
  const R s = z / distance;
  const auto add = [&](std::array<R, 4>& to, std::array<R, 4> of) {
    R scale = 1;
    for (R& sum : of) {
      sum *= scale / distance;
      scale *= ratio;
    }
    to[0] += s * s * s * of[0];
    to[1] += s * s * (q * of[0] - of[1]);
    to[2] += s * (q * (q * of[0] - 2 * of[1]) + of[2]);
    to[3] += q * (q * (q * of[0] - 3 * of[1]) + 3 * of[2]) - of[3];
  };
  add(sums.normal, n);
  add(sums.tangential, t);
}

}  // namespace steadyslide::numeric
