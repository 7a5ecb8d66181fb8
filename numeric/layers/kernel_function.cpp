#include "numeric/layers/kernel_function.hpp"

#include "numeric/quadrature/jacobi_rule.hpp"

namespace steadyslide::numeric {
namespace {

/// Returns Clenshaw's sum of c_m T_m(v).
template <Real R>
R chebyshev_sum(const std::vector<R>& series, const R& v) {
  R last = 0, before = 0;
  for (std::size_t m = series.size(); m-- > 1;) {
    const R next = 2 * v * last - before + series[m];
    before = last;
    last = next;
  }
  return v * last - before + series[0];
}

template <Real R>
R value_on(const typename KernelFunction<R>::Panel& panel, const R& y) {
  return chebyshev_sum(panel.series, R((2 * y - panel.left - panel.right) / (panel.right - panel.left)));
}

/// Gauss-Legendre rules with 1, 2, ... nodes.
template <Real R>
const UnitRule<R>& gauss_rule(std::size_t n) {
  static const std::vector<UnitRule<R>> rules = [] {
    std::vector<UnitRule<R>> made;
    for (int m = 1; m <= (std::same_as<R, double> ? 20 : std::same_as<R, Real50> ? 40 : 72); ++m) {
      made.push_back(jacobi_rule<R>({}, {}, m));
    }
    return made;
  }();
  return rules[min(n, rules.size()) - 1];
}

/// Returns how many Gauss nodes integrate a series of this size, times a line, over a part of its panel. The series is
/// exact to rounding, so its terms fall at least like rho^-m, and faster on a part of the panel.
template <Real R>
std::size_t gauss_nodes(std::size_t size, double part) {
  const double digits = -std::log(static_cast<double>(epsilon<R>()));
  const double rho = std::exp(digits / static_cast<double>(size));
  const double distance = (rho - 1 / rho) / 2 / part;
  const double degree = digits / std::log(distance + std::sqrt(1 + distance * distance));
  return 1 + static_cast<std::size_t>((std::min(degree, static_cast<double>(size)) + 2) / 2);
}

}  // namespace

template <Real R>
KernelFunction<R> KernelFunction<R>::antiderivative(R at_left) const {
  std::vector<Panel> result;
  for (const Panel& panel : panels_) {
    const std::size_t n = panel.series.size();
    const auto coefficient = [&](std::size_t m) { return m < n ? panel.series[m] : R(0); };
    const R quarter = (panel.right - panel.left) / 4;
    std::vector<R> series{R(0)};
    for (std::size_t m = 1; m <= n; ++m) {
      const R below = m == 1 ? R(2 * coefficient(0)) : coefficient(m - 1);
      series.push_back(quarter * (below - coefficient(m + 1)) / static_cast<int>(m));
    }
    series[0] = at_left - chebyshev_sum(series, R(-1));
    at_left = chebyshev_sum(series, R(1));
    result.push_back({panel.left, panel.right, std::move(series)});
  }
  return {parity_ == Parity::even ? Parity::odd : Parity::even, std::move(result)};
}

template <Real R>
const typename KernelFunction<R>::Panel& KernelFunction<R>::panel_at(const R& y) const {
  const auto after = std::upper_bound(panels_.begin() + 1, panels_.end(), y,
                                      [](const R& place, const Panel& panel) { return place < panel.left; });
  return *(after - 1);
}

template <Real R>
R KernelFunction<R>::at(const R& y) const {
  if (panels_.empty()) return 0;
  const R distance = abs(y);
  const R value = value_on(panel_at(distance), distance);
  return y < 0 && parity_ == Parity::odd ? R(-value) : value;
}

template <Real R>
R KernelFunction<R>::integral(const R& a, const R& b, const R& p, const R& q) const {
  if (panels_.empty()) return 0;
  if (a < 0 && b > 0) return integral(a, R(0), p, q) + integral(R(0), b, R(p - q * a), q);
  if (a < 0) {
    const R mirrored = integral(R(-b), R(-a), R(p + q * (b - a)), R(-q));
    return parity_ == Parity::odd ? R(-mirrored) : mirrored;
  }
  R sum = 0;
  R from = a;
  for (const Panel* panel = &panel_at(a);; ++panel) {
    const bool is_last = panel == &panels_.back() || b <= panel->right;
    const R to = is_last ? b : panel->right;
    const R length = to - from;
    const auto part = static_cast<double>(length) / static_cast<double>(panel->right - panel->left);
    if (length > 0) {
      const UnitRule<R>& rule = gauss_rule<R>(gauss_nodes<R>(panel->series.size(), part));
      R over_panel = 0;
      for (std::size_t k = 0; k < rule.size(); ++k) {
        const R y = from + length * rule.from_left[k];
        over_panel += rule.weights[k] * (p + q * (y - a)) * value_on(*panel, y);
      }
      sum += length * over_panel;
    }
    if (is_last) return sum;
    from = to;
  }
}

template <Real R>
R KernelFunction<R>::mean(const R& y, const R& h) const {
  return integral(R(y - h / 2), R(y + h / 2), R(1), R(0)) / h;
}

template <Real R>
R KernelFunction<R>::mean_of_cells(const R& y, const R& h) const {
  const R slope = 1 / h;
  return (integral(R(y - h), y, R(0), slope) + integral(y, R(y + h), R(1), R(-slope))) / h;
}

STEADYSLIDE_INSTANTIATE_CLASS(KernelFunction)

}  // namespace steadyslide::numeric
