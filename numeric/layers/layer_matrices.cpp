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
Matrix2<R> reflection(const R& gamma, const HeldSide<R>& below) {
  return (half_plane_compliance(gamma) * below.tractions - below.displacements) *
         (below.displacements + half_plane_compliance(R(-gamma)) * below.tractions).inverse();
}

template <Real R>
Matrix2<R> thick_layer_defect(const R& gamma, const R& xi, const HeldSide<R>& below) {
  const Matrix2<R> surface = rising(xi) * reflection(gamma, below) * falling(xi);
  return R(2) * (surface * (Matrix2<R>{R(1), R(0), R(0), R(1)} + surface).inverse());  // M + M* = 2
}

template <Real R>
HeldSide<R> raised(const R& gamma, const R& rest, const R& xi, const HeldSide<R>& below) {
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
  return {w_of_w * below.displacements + w_of_p * below.tractions,
          p_of_w * below.displacements + p_of_p * below.tractions};
}

#define STEADYSLIDE_INSTANTIATE(R)                                                \
  template Matrix2<R> reflection(const R&, const HeldSide<R>&);                   \
  template Matrix2<R> thick_layer_defect(const R&, const R&, const HeldSide<R>&); \
  template HeldSide<R> raised(const R&, const R&, const R&, const HeldSide<R>&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
