// The Riemann-Hilbert form at infinity: expansions of Y, polynomial parts, moments.

#include "numeric/riemann_hilbert/riemann_hilbert_form.hpp"

namespace steadyslide::numeric {
namespace {

/// Subtracts term x^j from entry j.
template <Real R>
void subtract_powers(std::vector<R>& moments, R term, const R& x) {
  for (R& m : moments) {
    m -= term;
    term *= x;
  }
}

}  // namespace

template <Real R>
void RiemannHilbertForm<R>::expand_at_infinity() {
  const int S = degree_;
  const int g = problem_->highest_degree();
  const auto count = static_cast<std::size_t>(std::max({g + 2, g - S, S + 1, 2})) + 1;
  // log Y = S log z - sum_k sigma_k z^-k/k, sigma_k the power sums of the singular points.
  std::vector<R> sigma(count, R(0));
  for (std::size_t j = 0; j < set_.points().size(); ++j) {
    const R& p = weight_.powers()[j].value;
    if (p == 0) continue;
    R term = p;
    for (std::size_t k = 1; k < count; ++k) {
      term *= set_.x(j);
      sigma[k] += term;
    }
  }
  series_.assign(count, R(0));
  inverse_series_.assign(count, R(0));
  series_[0] = inverse_series_[0] = 1;
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t k = 1; k <= i; ++k) {
      series_[i] -= sigma[k] * series_[i - k];
      inverse_series_[i] += sigma[k] * inverse_series_[i - k];
    }
    series_[i] /= static_cast<double>(i);
    inverse_series_[i] /= static_cast<double>(i);
  }
}

template <Real R>
const std::vector<R>& RiemannHilbertForm<R>::polynomial(std::size_t slope) const {
  std::vector<R>& result = polynomials_[slope];
  if (!result.empty()) return result;
  std::vector<R> g = problem_->slopes()[slope];
  if (g.empty()) g.push_back(R(0));
  g[0] += tilt_;
  const int top = std::max({static_cast<int>(g.size()) - 1 - degree_, static_cast<int>(q_.size()) - 1, 0});
  result.assign(static_cast<std::size_t>(top) + 1, R(0));
  for (int j = 0; j <= top; ++j) {
    for (int l = std::max(j + degree_, 0); l < static_cast<int>(g.size()); ++l) {
      result[static_cast<std::size_t>(j)] +=
          g[static_cast<std::size_t>(l)] * inverse_series_[static_cast<std::size_t>(l - degree_ - j)];
    }
  }
  for (std::size_t j = 0; j < q_.size(); ++j) result[j] -= q_[j] / pi<R>();
  return result;
}

template <Real R>
R RiemannHilbertForm<R>::tilt_polynomial(const R& x) const {
  R value = 0;
  for (int j = -degree_; j >= 0; --j) value = value * x + inverse_series_[static_cast<std::size_t>(-degree_ - j)];
  return value;
}

template <Real R>
R RiemannHilbertForm<R>::moment_of_load() const {
  // u'/c = -(1/pi) (int t/z + int xi t/z^2 + ...), and it is Y (m_0/z + ... + q/pi).
  const auto count = static_cast<std::size_t>(std::max(degree_ + 2, 0));
  const std::vector<R> m = moments(count);
  R sum = 0;
  for (std::size_t j = 0; j < count; ++j) sum += m[j] * series_[count - 1 - j];
  for (std::size_t l = 0; l < q_.size(); ++l) {
    const int index = degree_ + 2 + static_cast<int>(l);
    if (index >= 0) sum += q_[l] / pi<R>() * series_[static_cast<std::size_t>(index)];
  }
  return sum * pi<R>();
}

template <Real R>
R RiemannHilbertForm<R>::tilt_moment(std::size_t j) const {
  const int index = 1 + static_cast<int>(j) - degree_;
  return index < 0 ? R(0) : inverse_series_[static_cast<std::size_t>(index)];
}

template <Real R>
std::vector<R> RiemannHilbertForm<R>::moments(std::size_t count) const {
  std::vector<R> result(count, R(0));
  if (set_.components() > 1) {
    // -(1/pi) int h xi^j, h = eps cos(pi alpha) (g + tilt)/|Y|: the expansion at infinity would be a small difference
    // of large terms where the components are small beside their distances.
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const R& x = nodes_[i].node.x;
      const std::size_t own = slope_at(static_cast<std::size_t>(nodes_[i].segment));
      subtract_powers(result, R(node_weights_[i] * (problem_->slope(own, x) + tilt_) / pi<R>()), x);
    }
    return result;
  }
  // One component: any k will do, and the polynomial's part is exact. The one of the longest segment is the smallest
  // there.
  std::size_t longest = set_.all(ContactSet<R>::Kind::begins).front();
  for (std::size_t segment = 0; segment < set_.segments(); ++segment) {
    if (set_.in_contact(segment) && set_.length(segment) > set_.length(longest)) longest = segment;
  }
  const std::size_t k = slope_at(longest);
  const std::vector<R>& g = problem_->slopes()[k];
  for (std::size_t j = 0; j < count; ++j) {
    result[j] = tilt_ * tilt_moment(j);
    for (std::size_t l = 0; l < g.size(); ++l) {
      const int index = static_cast<int>(l) - degree_ + 1 + static_cast<int>(j);
      if (index >= 0) result[j] += g[l] * inverse_series_[static_cast<std::size_t>(index)];
    }
  }
  if (!panels_.empty()) {
    const std::vector<R>& f = density(k);
    for (std::size_t i = 0; i < f.size(); ++i) subtract_powers(result, R(f[i] / pi<R>()), nodes_[i].node.x);
  }
  return result;
}

#define STEADYSLIDE_INSTANTIATE(R)                                                           \
  template void RiemannHilbertForm<R>::expand_at_infinity();                                 \
  template const std::vector<R>& RiemannHilbertForm<R>::polynomial(std::size_t slope) const; \
  template R RiemannHilbertForm<R>::tilt_polynomial(const R& x) const;                       \
  template R RiemannHilbertForm<R>::moment_of_load() const;                                  \
  template R RiemannHilbertForm<R>::tilt_moment(std::size_t j) const;                        \
  template std::vector<R> RiemannHilbertForm<R>::moments(std::size_t count) const;
STEADYSLIDE_INSTANTIATE(double)
STEADYSLIDE_INSTANTIATE(Real50)
STEADYSLIDE_INSTANTIATE(Real100)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
