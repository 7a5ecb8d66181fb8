#include "numeric/riemann_hilbert/expansion_at_infinity.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::numeric {

template <Real R>
ExpansionAtInfinity<R>::ExpansionAtInfinity(const SignedFundamentalSolution<R>& y) : degree_(y.degree_at_infinity()) {
  const int S = degree_;
  const int g = y.problem().highest_degree();
  const auto count = static_cast<std::size_t>(std::max({g + 2, g - S, S + 1, 2})) + 1;
  // log Y = S log z - sum_k sigma_k z^-k/k, where sigma_k are the power sums of the singular points.
  std::vector<R> sigma(count, R(0)), sigma_sizes(count, R(0));
  for (std::size_t j = 0; j < y.set().points().size(); ++j) {
    const R& p = y.fundamental_solution().powers()[j].value;
    if (p == 0) continue;
    R term = p;
    for (std::size_t k = 1; k < count; ++k) {
      term *= y.set().x(j);
      sigma[k] += term;
      sigma_sizes[k] += abs(term);
    }
  }
  series_.assign(count, R(0));
  inverse_series_.assign(count, R(0));
  sizes_.assign(count, R(0));
  series_[0] = inverse_series_[0] = sizes_[0] = 1;
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t k = 1; k <= i; ++k) {
      series_[i] -= sigma[k] * series_[i - k];
      inverse_series_[i] += sigma[k] * inverse_series_[i - k];
      sizes_[i] += sigma_sizes[k] * abs(inverse_series_[i - k]) + abs(sigma[k]) * sizes_[i - k];
    }
    series_[i] /= static_cast<double>(i);
    inverse_series_[i] /= static_cast<double>(i);
    sizes_[i] /= static_cast<double>(i);
  }
}

template <Real R>
Estimate<R> ExpansionAtInfinity<R>::term(const R& g, std::size_t i) const {
  return {g * inverse_series_[i], 4 * epsilon<R>() * abs(g) * sizes_[i]};
}

template <Real R>
std::vector<Estimate<R>> ExpansionAtInfinity<R>::polynomial_part(const std::vector<R>& g) const {
  const int top = std::max(static_cast<int>(g.size()) - 1 - degree_, 0);
  std::vector<Estimate<R>> result(static_cast<std::size_t>(top) + 1);
  for (int j = 0; j <= top; ++j) {
    for (int l = std::max(j + degree_, 0); l < static_cast<int>(g.size()); ++l) {
      result[static_cast<std::size_t>(j)] +=
          term(g[static_cast<std::size_t>(l)], static_cast<std::size_t>(l - degree_ - j));
    }
  }
  return result;
}

template <Real R>
Estimate<R> ExpansionAtInfinity<R>::moment(const std::vector<R>& g, const R& tilt, std::size_t j) const {
  Estimate<R> result;
  if (const int index = 1 + static_cast<int>(j) - degree_; index >= 0) {
    result = term(tilt, static_cast<std::size_t>(index));
  }
  for (std::size_t l = 0; l < g.size(); ++l) {
    const int index = static_cast<int>(l) - degree_ + 1 + static_cast<int>(j);
    if (index >= 0) result += term(g[l], static_cast<std::size_t>(index));
  }
  return result;
}

template <Real R>
R ExpansionAtInfinity<R>::tilt_polynomial(const R& x) const {
  R value = 0;
  for (int j = -degree_; j >= 0; --j) value = value * x + inverse_series_[static_cast<std::size_t>(-degree_ - j)];
  return value;
}

template <Real R>
R ExpansionAtInfinity<R>::tilt_moment(std::size_t j) const {
  const int index = 1 + static_cast<int>(j) - degree_;
  return index < 0 ? R(0) : inverse_series_[static_cast<std::size_t>(index)];
}

STEADYSLIDE_INSTANTIATE_CLASS(ExpansionAtInfinity)

}  // namespace steadyslide::numeric
