#pragma once
// Displacements whose tractions are known: with p = 1/2+alpha, q = 1/2-alpha and W = (1+x)^p (1-x)^q
//
//   u = (2/n) P_n^{(-p,-q)}   ->   L(u) = 2 cos(pi alpha) P_n^{(-q,-p)}/W,   n >= 1,
//
// (P_n^{(a,b)}: the power a at x = 1, b at x = -1). For u' = P_{n-1}^{(q,p)} [DLMF, 18.9.15]; and by Plemelj's formulas
// cos(pi alpha) A(P_n^{(-q,-p)}/W) is the polynomial part at infinity of P_n^{(-q,-p)} (z+1)^{-p} (z-1)^{-q}, which has
// the degree n - 1, the leading coefficient of P_n^{(-q,-p)}, half of P_{n-1}^{(q,p)}'s, and is orthogonal to lower
// degrees under W: P_{n-1}^{(q,p)}/2.

#include "numeric/number/node.hpp"

namespace steadyslide::proofs_checks {

/// P_n^{(a,b)}(x) for a + b = -1.
template <numeric::Real R>
R jacobi_polynomial(int n, const R& a, const R& x) {
  const R b = -1 - a;
  R before = 1;
  R here = (a + 1) + (x - 1) / 2;
  if (n == 0) return before;
  for (int k = 2; k <= n; ++k) {
    const R next = ((2 * k - 2) * ((2 * k - 1) * R(2 * k - 3) * x + (a * a - b * b)) * here -
                    2 * (k - 1 + a) * (k - 1 + b) * (2 * k - 1) * before) /
                   (R(2 * k) * (k - 1) * (2 * k - 3));
    before = here;
    here = next;
  }
  return here;
}

/// sum_n c_n u_n and W L of it, n = 1, ..., c.size().
template <class R>
struct JacobiPair {
  Rational s;
  std::vector<R> c;

  R displacement(const R& x) const { return sum(-(R(1) / 2 + angle()), x, false); }
  R traction(const R& x) const { return 2 * numeric::cos_pi_alpha<R>(s) * sum(angle() - R(1) / 2, x, true); }

 private:
  R angle() const { return numeric::to_real<R>(Exponent::angle(s)); }
  R sum(const R& at_right, const R& x, bool image) const {
    R total = 0;
    for (std::size_t k = 0; k < c.size(); ++k) {
      const int n = static_cast<int>(k) + 1;
      total += c[k] * jacobi_polynomial<R>(n, at_right, x) * (image ? R(1) : R(2) / n);
    }
    return total;
  }
};

}  // namespace steadyslide::proofs_checks
