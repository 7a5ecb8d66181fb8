#pragma once
// Complex numbers at every precision, as far as potentials of polynomial tractions need them: std::complex is for the
// built-in types only.

#include <cmath>
#include <vector>

#include "numeric/cauchy/fundamental_solution.hpp"

namespace steadyslide::proofs_checks {

using numeric::Complex;

template <class R>
Complex<R> operator+(const Complex<R>& a, const Complex<R>& b) {
  return {a.re + b.re, a.im + b.im};
}
template <class R>
Complex<R> operator-(const Complex<R>& a, const Complex<R>& b) {
  return {a.re - b.re, a.im - b.im};
}
template <class R>
Complex<R> operator*(const Complex<R>& a, const Complex<R>& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <class R>
Complex<R> operator*(const R& a, const Complex<R>& b) {
  return {a * b.re, a * b.im};
}
template <class R>
Complex<R> reciprocal(const Complex<R>& a) {
  const R size = a.re * a.re + a.im * a.im;
  return {a.re / size, -a.im / size};
}
/// With an argument in [0, pi] for Im >= 0.
template <class R>
Complex<R> logarithm(const Complex<R>& a) {
  using std::atan2, std::log;
  return {log(a.re * a.re + a.im * a.im) / 2, atan2(a.im, a.re)};
}

/// An analytic function and two derivatives.
template <class R>
struct Jet {
  numeric::Complex<R> value;
  numeric::Complex<R> first;
  numeric::Complex<R> second;
};

/// Of a polynomial, from its coefficients.
template <class R>
Jet<R> polynomial_jet(const std::vector<R>& p, const Complex<R>& x) {
  Jet<R> jet{{0, 0}, {0, 0}, {0, 0}};
  for (std::size_t k = p.size(); k-- > 0;) {
    jet.second = jet.second * x + R(2) * jet.first;
    jet.first = jet.first * x + jet.value;
    jet.value = jet.value * x + Complex<R>{p[k], 0};
  }
  return jet;
}

}  // namespace steadyslide::proofs_checks
