#include "numeric/layers/layer_matrices.hpp"

namespace steadyslide::numeric {
namespace {

/// Returns x cosh x - sinh x = sum 2n x^(2n+1)/(2n+1)! for |x| <= 1.
template <Real R>
R x_cosh_minus_sinh(const R& x) {
  R term = x * x * x / 6;  // x^(2n+1)/(2n+1)!
  R sum = 0;
  for (int n = 1; 2 * n * abs(term) > epsilon<R>() / 4 * abs(sum); ++n) {
    sum += 2 * n * term;
    term *= x * x / ((2 * n + 2) * (2 * n + 3));
  }
  return sum;
}

}  // namespace

template <Real R>
Matrix2<R> thick_layer_defect(const R& gamma, const R& xi, const HeldSide<R>& below) {
  const Matrix2<R> one{R(1), R(0), R(0), R(1)};
  const Matrix2<R> down = half_plane_compliance(gamma);
  const Matrix2<R> up = half_plane_compliance(R(-gamma));
  // The traction of the upward field over that of the downward field, at the lower side and at the surface.
  const Matrix2<R> lower =
      (down * below.tractions - below.displacements) * (below.displacements + up * below.tractions).inverse();
  const Matrix2<R> rises{1 + xi, -xi, xi, 1 - xi};
  const Matrix2<R> falls{1 + xi, xi, -xi, 1 - xi};
  const Matrix2<R> surface = exp(R(-2 * xi)) * (rises * lower * falls);
  return R(2) * (surface * (one + surface).inverse());  // M + M* = 2
}

template <Real R>
Matrix2<R> thin_layer_compliance(const R& gamma, const R& rest, const R& xi, const HeldSide<R>& below) {
  const R s = sinh(xi);
  const R c = cosh(xi);
  const R t = xi * s;
  const R d = x_cosh_minus_sinh(xi);
  const R a = 1 - 2 * gamma;
  // The state at the surface from that at the lower side: exp(-xi A) for the equations (w, v, p, q)' = A (w, v, p, q).
  // (A^2 - 1)^2 = 0.
  const Matrix2<R> w_of_w{c - rest * t, -a * s - rest * d, s + rest * d, c + rest * t};
  const Matrix2<R> w_of_p{rest * (2 * gamma * s - rest * d), -rest * rest * t, rest * rest * t,
                          rest * (2 * s + rest * d)};
  const Matrix2<R> p_of_w{-d, -t, t, 2 * s + d};
  const Matrix2<R> p_of_p{c - rest * t, -s - rest * d, a * s + rest * d, c + rest * t};
  return (w_of_w * below.displacements + w_of_p * below.tractions) *
         (p_of_w * below.displacements + p_of_p * below.tractions).inverse();
}

#define STEADYSLIDE_INSTANTIATE(R)                                                \
  template Matrix2<R> thick_layer_defect(const R&, const R&, const HeldSide<R>&); \
  template Matrix2<R> thin_layer_compliance(const R&, const R&, const R&, const HeldSide<R>&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
