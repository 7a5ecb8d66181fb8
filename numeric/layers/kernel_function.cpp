#include "numeric/layers/kernel_function.hpp"

#include <algorithm>

#include "numeric/number/chebyshev.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
R value_on(const typename KernelFunction<R>::Panel& panel, const R& y) {
  return chebyshev_sum(panel.series, R((2 * y - panel.left - panel.right) / (panel.right - panel.left)));
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

STEADYSLIDE_INSTANTIATE_CLASS(KernelFunction)

}  // namespace steadyslide::numeric
