#pragma once
// One elastic layer at one wave number k. With z downwards and zeta = k z,
//
//   u_z = (c/k) w cos(kx), u_x = -(c/k) v sin(kx), sigma_zz = -p cos(kx), sigma_xz = q sin(kx),
//   w' = (1-2 gamma) v - 2 gamma (1-gamma) p,   v' = -w - 2 (1-gamma) q,   p' = q,   q' = -2 v - (1-2 gamma) p
//
// (Hooke and equilibrium, c and gamma of the layer, ' = d/d zeta). (p, q) is the traction on the part below. Fields that
// decay downwards have (w, v) = M (p, q), those that decay upwards (w, v) = -M* (p, q), and their tractions are
//
//   exp(-zeta) (1 + zeta N) (p, q)(0),   M  = (1, gamma; gamma, 1),     N  = (1, 1; -1, -1),
//   exp(zeta) (1 - zeta N*) (p, q)(0),   M* = (1, -gamma; -gamma, 1),   N* = (1, -1; 1, -1).

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

/// The matrix (a, b; c, d).
template <Real R>
struct Matrix2 {
  R a = 0;
  R b = 0;
  R c = 0;
  R d = 0;

  friend Matrix2 operator+(const Matrix2& m, const Matrix2& n) { return {m.a + n.a, m.b + n.b, m.c + n.c, m.d + n.d}; }
  friend Matrix2 operator-(const Matrix2& m, const Matrix2& n) { return {m.a - n.a, m.b - n.b, m.c - n.c, m.d - n.d}; }
  friend Matrix2 operator*(const R& s, const Matrix2& m) { return {s * m.a, s * m.b, s * m.c, s * m.d}; }
  friend Matrix2 operator*(const Matrix2& m, const Matrix2& n) {
    return {m.a * n.a + m.b * n.c, m.a * n.b + m.b * n.d, m.c * n.a + m.d * n.c, m.c * n.b + m.d * n.d};
  }
  Matrix2 inverse() const { return (1 / R(a * d - b * c)) * Matrix2{d, -b, -c, a}; }
};

/// The states that the lower side of a layer admits: (w, v) = displacements e, (p, q) = tractions e for any e.
template <Real R>
struct HeldSide {
  Matrix2<R> displacements;
  Matrix2<R> tractions;

  Matrix2<R> compliance() const { return displacements * tractions.inverse(); }
};

/// Returns the side that a body of this compliance holds, in units of the layer's c/k: bonded, or free to slip. On a
/// soft body the larger displacement is given instead of the traction that goes with it. Otherwise a stiff layer would
/// lose digits.
template <Real R>
HeldSide<R> held_by(const Matrix2<R>& m, bool bonded) {
  if (!bonded) return {{m.a, R(0), R(0), R(1)}, {R(1), R(0), R(0), R(0)}};
  if (m.a <= 1 && m.d <= 1) return {m, {R(1), R(0), R(0), R(1)}};
  if (m.a <= m.d) {
    const R share = m.c / m.d;
    return {{m.a - m.b * share, share, R(0), R(1)}, {R(1), R(0), -share, 1 / m.d}};
  }
  const R share = m.b / m.a;
  return {{R(1), R(0), share, m.d - m.c * share}, {1 / m.a, -share, R(0), R(1)}};
}

/// Returns M.
template <Real R>
Matrix2<R> half_plane_compliance(const R& gamma) {
  return {R(1), gamma, gamma, R(1)};
}

/// Returns exp(-zeta) (1 + zeta N), which takes the traction of the downward field down by zeta.
template <Real R>
Matrix2<R> falling(const R& zeta) {
  return exp(R(-zeta)) * Matrix2<R>{1 + zeta, zeta, -zeta, 1 - zeta};
}

/// Returns exp(-zeta) (1 + zeta N*), which takes the traction of the upward field up by zeta.
template <Real R>
Matrix2<R> rising(const R& zeta) {
  return exp(R(-zeta)) * Matrix2<R>{1 + zeta, -zeta, zeta, 1 - zeta};
}

/// Returns the traction of the upward field over that of the downward field at the lower side.
template <Real R>
Matrix2<R> reflection(const R& gamma, const HeldSide<R>& below);

/// Returns M minus the compliance of the surface, for xi = k h > 1. It decays like exp(-2 xi) and loses no digit.
template <Real R>
Matrix2<R> thick_layer_defect(const R& gamma, const R& xi, const HeldSide<R>& below);

/// Returns the states at a height xi <= 1 above the lower side, for the same e; `rest` = 1 - gamma. Their relative
/// errors are a few epsilon, also for small xi, for nearly incompressible layers and for bodies below that are much
/// softer or stiffer.
template <Real R>
HeldSide<R> raised(const R& gamma, const R& rest, const R& xi, const HeldSide<R>& below);

}  // namespace steadyslide::numeric
