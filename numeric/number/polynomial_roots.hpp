#pragma once
// Where a polynomial changes its sign: between neighbouring zeros of its derivative it does so once at most.

#include <limits>
#include <vector>

#include "numeric/number/polynomial.hpp"

namespace steadyslide::numeric {

/// The places in ]a, b[ where the polynomial with these coefficients of 1, x, x^2, ... changes its sign, left to right.
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
