#pragma once
// Polynomials sum_k a_k x^k at real places, by Horner's rule.

#include <limits>
#include <vector>

#include "model/polynomial.hpp"
#include "numeric/number/estimate.hpp"
#include "numeric/number/mapped.hpp"

namespace steadyslide::numeric {

/// Returns the coefficients of 1, x, x^2, ..., each rounded once.
template <Real R>
std::vector<R> coefficients_of(const Polynomial& p) {
  return mapped(p.coefficients(), [](const Rational& c) { return to_real<R>(c); });
}

/// Returns the value at x; 0 if there are no coefficients.
template <Real R>
R value_of(const std::vector<R>& coefficients, const R& x) {
  R value = 0;
  for (std::size_t k = coefficients.size(); k-- > 0;) value = value * x + coefficients[k];
  return value;
}

/// Returns an estimate of the rounding error of the value at x, in units of epsilon: of x and of each coefficient once,
/// and of Horner's rule. It adds absolute values, so terms that cancel in the value do not cancel here.
template <Real R>
double rounding_size(const std::vector<R>& coefficients, const R& x) {
  double size = 0;
  const double magnitude = std::abs(static_cast<double>(x));
  for (std::size_t k = coefficients.size(); k-- > 0;) {
    size = size * magnitude + static_cast<double>(3 * k + 2) * std::abs(static_cast<double>(coefficients[k]));
  }
  return size;
}

template <Real R>
Estimate<R> estimate_of(const std::vector<R>& coefficients, const R& x) {
  return {value_of(coefficients, x), epsilon<R>() * rounding_size(coefficients, x)};
}

template <Real R>
R value_of(const Polynomial& p, const R& x) {
  return value_of(coefficients_of<R>(p), x);
}

/// Returns, from left to right, the places in ]a, b[ where the polynomial with these coefficients changes its sign.
/// Between neighbouring zeros of its derivative there is at most one.
inline std::vector<double> sign_changes(const std::vector<double>& coefficients, double a, double b) {
  if (coefficients.size() < 2) return {};
  const auto value = [&](double x) { return value_of(coefficients, x); };
  std::vector<double> derivative;
  for (std::size_t k = 1; k < coefficients.size(); ++k) derivative.push_back(static_cast<double>(k) * coefficients[k]);
  std::vector<double> cuts = sign_changes(derivative, a, b);
  cuts.insert(cuts.begin(), a);
  cuts.push_back(b);
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    double low = cuts[i];
    double high = cuts[i + 1];
    const bool rising = value(high) > 0;
    if ((value(low) > 0) == rising) continue;
    for (int step = 0; step < 2 * std::numeric_limits<double>::digits; ++step) {
      const double middle = low + (high - low) / 2;
      if (middle <= low || middle >= high) break;
      ((value(middle) > 0) == rising ? high : low) = middle;
    }
    result.push_back(low + (high - low) / 2);
  }
  return result;
}

}  // namespace steadyslide::numeric
