#pragma once
// Complex numbers at every precision, with the functions that potentials of polynomial tractions need. std::complex is
// for the built-in types only.

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
/// Returns the logarithm, with an argument in [0, pi] for Im >= 0.
template <class R>
Complex<R> logarithm(const Complex<R>& a) {
  using std::atan2, std::log;
  return {log(a.re * a.re + a.im * a.im) / 2, atan2(a.im, a.re)};
}

/// The value of an analytic function and its first two derivatives.
template <class R>
struct Jet {
  Complex<R> value{0, 0};
  Complex<R> first{0, 0};
  Complex<R> second{0, 0};
};
template <class R>
Jet<R> operator+(const Jet<R>& a, const Jet<R>& b) {
  return {a.value + b.value, a.first + b.first, a.second + b.second};
}
template <class R>
Jet<R> operator*(const Jet<R>& a, const Jet<R>& b) {
  return {a.value * b.value, a.first * b.value + a.value * b.first,
          a.second * b.value + R(2) * (a.first * b.first) + a.value * b.second};
}
template <class R>
Jet<R> operator*(const R& a, const Jet<R>& b) {
  return {a * b.value, a * b.first, a * b.second};
}

/// Returns the jet of a polynomial from its coefficients.
template <class R>
Jet<R> polynomial_jet(const std::vector<R>& p, const Complex<R>& x) {
  const Jet<R> z{x, {1, 0}};
  Jet<R> jet;
  for (std::size_t k = p.size(); k-- > 0;) jet = jet * z + Jet<R>{{p[k], 0}};
  return jet;
}

}  // namespace steadyslide::proofs_checks
