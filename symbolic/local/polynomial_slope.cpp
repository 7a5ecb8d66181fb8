#include "symbolic/local/polynomial_slope.hpp"

#include <algorithm>
#include <stdexcept>

#include "symbolic/field/expression.hpp"

namespace steadyslide::symbolic {

using GiNaC::ex;

namespace {

ex at(const std::vector<ex>& coefficients, int k) {
  return k < 0 || k >= static_cast<int>(coefficients.size()) ? ex(0) : coefficients[static_cast<std::size_t>(k)];
}

}  // namespace

std::vector<ex> power_sums(const std::vector<ex>& powers, const std::vector<ex>& places, std::size_t count) {
  std::vector<ex> sums;
  for (std::size_t k = 1; k <= count; ++k) {
    ex sum = 0;
    for (std::size_t j = 0; j < powers.size(); ++j) sum += powers[j] * GiNaC::pow(places.at(j), static_cast<int>(k));
    sums.push_back(sum);
  }
  return sums;
}

std::vector<ex> power_sum_symbols(std::size_t count) { return symbols("sigma", count, 1); }

std::vector<ex> series_at_infinity(const std::vector<ex>& sums, int sign, std::size_t count) {
  // Uses E' = sign * (sum sigma_k u^(k-1)) E.
  std::vector<ex> series{1};
  for (std::size_t n = 1; n <= count; ++n) {
    ex sum = 0;
    for (std::size_t k = 1; k <= n; ++k) sum += sums.at(k - 1) * series[n - k];
    series.push_back((sign * sum / static_cast<int>(n)).expand());
  }
  return series;
}

std::vector<ex> binomial_product(const std::vector<ex>& powers, const std::vector<ex>& places, std::size_t count) {
  std::vector<ex> product(count + 1, 0);
  product[0] = 1;
  for (std::size_t j = 0; j < powers.size(); ++j) {
    std::vector<ex> next(count + 1, 0);
    ex term = 1;
    for (std::size_t n = 0; n <= count; ++n) {
      for (std::size_t k = 0; k + n <= count; ++k) next[k + n] += term * product[k];
      term *= -places.at(j) * (powers[j] - static_cast<int>(n)) / static_cast<int>(n + 1);
    }
    product = std::move(next);
  }
  return product;
}

std::size_t PolynomialSlope::sums_needed(int order, std::size_t slope_size) {
  return static_cast<std::size_t>(std::max(static_cast<int>(slope_size), static_cast<int>(slope_size) - 1 - order));
}

PolynomialSlope::PolynomialSlope(int order, std::vector<ex> slope, const std::vector<ex>& sums, const ex& load_over_pi)
    : order_(order), slope_(std::move(slope)) {
  const int top = static_cast<int>(slope_.size()) - 1;
  const std::vector<ex> reciprocal = series_at_infinity(sums, +1, sums_needed(order, slope_.size()));
  // The coefficient of z^power in psi'/Y.
  const auto quotient = [&](int power) {
    ex sum = 0;
    for (int m = 0; m <= top; ++m) sum += at(slope_, m) * at(reciprocal, m - order - power);
    return sum.expand();
  };
  for (int j = 0; j <= std::max(top - order, -order - 1); ++j) factor_.push_back(quotient(j));
  if (order < 0) {
    for (int j = 0; j < -order - 1; ++j) {
      free_coefficients_.emplace_back(GiNaC::symbol("q_" + std::to_string(j)));
      factor_[static_cast<std::size_t>(j)] += free_coefficients_.back();
    }
    factor_[static_cast<std::size_t>(-order - 1)] -= load_over_pi;
  } else {
    for (int k = 1; k <= order; ++k) conditions_.push_back(quotient(-k));
    conditions_.push_back(quotient(-order - 1) - load_over_pi);
  }
}

ex field_coefficient(int order, const std::vector<ex>& slope, const std::vector<ex>& factor,
                     const std::vector<ex>& series, int power) {
  ex value = at(slope, power);
  for (std::size_t j = 0; j < factor.size(); ++j) {
    const int n = order + static_cast<int>(j) - power;
    if (n < 0) continue;
    if (n >= static_cast<int>(series.size())) throw std::domain_error("field at infinity: more terms of the series");
    value -= factor[j] * at(series, n);
  }
  return value;
}

}  // namespace steadyslide::symbolic
