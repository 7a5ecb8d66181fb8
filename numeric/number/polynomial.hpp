#pragma once
// Polynomials sum_k a_k x^k at real places, by Horner's rule.

#include <vector>

#include "model/polynomial.hpp"
#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

/// The coefficients of 1, x, x^2, ..., each rounded once.
template <Real R>
std::vector<R> coefficients_of(const Polynomial& p) {
  std::vector<R> result;
  result.reserve(p.coefficients().size());
  for (const Rational& c : p.coefficients()) result.push_back(to_real<R>(c));
  return result;
}

/// The value at x; 0 without coefficients.
template <Real R>
R value_of(const std::vector<R>& coefficients, const R& x) {
  R value = 0;
  for (std::size_t k = coefficients.size(); k-- > 0;) value = value * x + coefficients[k];
  return value;
}

template <Real R>
R value_of(const Polynomial& p, const R& x) {
  return value_of(coefficients_of<R>(p), x);
}

}  // namespace steadyslide::numeric
