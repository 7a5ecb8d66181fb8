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
// The sums
//
//   P_0 = sum_i n_i atan(X/z),   P_1 = sum_i n_i log d,   P_2 = sum_i n_i X z/d^2,   P_3 = sum_i n_i z^2/d^2
//
// give the displacement (interior_displacement.hpp) and the integrals of the stresses along x (average_stress.hpp).
//
// Many forces around c, |x_i - c| <= h, are represented by their moments m_k = sum_i n_i ((x_i - c)/h)^k. Since
// 1/(1 - 2 q s + s^2)^2 = sum_k C_k(q) s^k with Gegenbauer's polynomials C_k of index 2, at a distance D >= 3 h with
// q = (x - c)/D
//
//   M_j = (z/D)^(3-j)/D sum_i n_i (q - s_i)^j sum_k C_k(q) s_i^k,   s_i = (x_i - c)/D:
//
// small stresses under a free surface keep their digits. Since |C_k| <= (k+1)(k+2)(k+3)/6, the omitted terms are below
// k^3/4 3^-k sum |n_i|/D. With w = (x - c + iz)/h,
//
//   P_1 + i (pi/2 m_0 - P_0) = m_0 log(h w) - sum_k>0 m_k/(k w^k),   P_2 - i P_3 = (z/h) sum_k m_k/w^(k+1).

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

/// Four sums of the normal and of the tangential forces, and their errors.
template <Real R>
struct ForceSums {
  std::array<R, 4> normal{};
  std::array<R, 4> tangential{};
  std::array<R, 4> normal_error{};
  std::array<R, 4> tangential_error{};
};

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

/// The sums M_j.
template <Real R>
struct StressKernel {
  /// Adds a force.
  static void add_force(std::array<R, 4>& sums, const R& force, const R& x, const R& z) {
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

  /// Adds forces with these moments. (x, z) is relative to c.
  static void add_far(ForceSums<R>& sums, const R* normal, const R* tangential, const R& h, const R& x, const R& z) {
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

  /// Returns the sizes of the sums of a panel, for their relative errors. `straddles`: there are forces on both sides of
  /// x, at horizontal distances up to the depth, which cancel in the odd sums.
  static std::array<R, 4> sizes(const std::array<R, 4>& sums, const R&, bool straddles) {
    std::array<R, 4> result;
    for (std::size_t j = 0; j < 4; ++j) {
      result[j] = abs(sums[j]);
      if (straddles && j % 2 == 1) result[j] = std::max(result[j], R(abs(sums[j - 1])));
    }
    return result;
  }
  /// Returns the length to which a panel with the power p is graded at a point at depth z above which it lies.
  static R smallest_scale(const R& z, const R&, const R&) { return z; }
  /// Returns the error of the sums due to a force at a distance below this length.
  static R unresolved(const R&) { return R(0); }
  /// Adds a constant traction between the distances x_right and x_left; false if quadrature is more accurate.
  static bool add_constant(std::array<R, 4>&, const R&, const R&, const R&, const R&) { return false; }
};

/// The sums P_j. They exist at the surface too.
template <Real R>
struct PotentialKernel {
  static void add_force(std::array<R, 4>& sums, const R& force, const R& x, const R& z) {
    using std::atan2;
    const R square = x * x + z * z, part = force * z / square;
    sums[0] += force * atan2(x, z);
    sums[1] += force * log(square) / 2;
    sums[2] += x * part;
    sums[3] += z * part;
  }

  static void add_far(ForceSums<R>& sums, const R* normal, const R* tangential, const R& h, const R& x, const R& z) {
    using std::atan2;
    const R square = x * x + z * z;
    const R re = h * x / square, im = -h * z / square;  // of 1/w
    const auto add = [&](std::array<R, 4>& to, const R* m) {
      R power_re = re, power_im = im;
      std::array<R, 4> series{};  // of log(1 - s/w) and of 1/(w - s): real and imaginary parts
      for (std::size_t k = 0; k + 3 < moment_count<R>(); ++k) {
        const R next = m[k + 1] / static_cast<double>(k + 1);
        series[0] -= next * power_re;
        series[1] -= next * power_im;
        series[2] += m[k] * power_re;
        series[3] += m[k] * power_im;
        const R turned = power_re * re - power_im * im;
        power_im = power_re * im + power_im * re;
        power_re = turned;
      }
      to[0] += m[0] * atan2(x, z) - series[1];
      to[1] += m[0] * log(square) / 2 + series[0];
      to[2] += z / h * series[2];
      to[3] -= z / h * series[3];
    };
    add(sums.normal, normal);
    add(sums.tangential, tangential);
  }

  static std::array<R, 4> sizes(const std::array<R, 4>& sums, const R& force, bool) {
    const R size = abs(force);
    return {2 * size, abs(sums[1]) + size, size, size};
  }
  /// The logarithm is graded until the load of the rest is negligible.
  static R smallest_scale(const R& z, const R& length, const R& p) {
    constexpr double most = 8;
    const R exponent = p < 0 ? std::min(R(1 / (1 + p)), R(most)) : R(1);
    return std::max(z, R(length * pow(epsilon<R>(), exponent)));
  }
  static R unresolved(const R& force) { return abs(force); }

  static bool add_constant(std::array<R, 4>& sums, const R& traction, const R& x_left, const R& x_right, const R& z) {
    using std::atan2;
    const auto add = [&](const R& factor, const R& x) {
      if (x == 0 && z == 0) return;
      const R angle = atan2(x, z), logarithm = log(x * x + z * z) / 2;
      sums[0] += factor * (x * angle - z * logarithm);
      sums[1] += factor * (x * logarithm - x + z * angle);
      sums[2] += factor * z * logarithm;
      sums[3] += factor * z * angle;
    };
    add(traction, x_left);
    add(-traction, x_right);
    return true;
  }
};

}  // namespace steadyslide::numeric
