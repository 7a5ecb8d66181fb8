#include "numeric/interior/interface_stress.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace steadyslide::numeric {
namespace {

/// The largest value of a function of x, with its place.
struct Peak {
  Estimate<double> value;
  Estimate<double> x;
};

/// `field` varies on the length `scale`; `places` are closer than that where it is large.
Peak highest(const std::vector<double>& places, double scale, const std::function<Estimate<double>(double)>& field) {
  std::vector<double> values;
  for (const double x : places) values.push_back(field(x).value);
  const double largest = *std::max_element(values.begin(), values.end());
  std::vector<Peak> peaks;
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    if (values[i] < 0.8 * largest || values[i] < values[i - 1] || values[i] < values[i + 1]) continue;
    // The golden section.
    constexpr double part = 0.3819660112501051;
    double left = places[i - 1], middle = places[i], right = places[i + 1], top = values[i];
    while (right - left > 1e-7 * scale) {
      const bool on_left = middle - left > right - middle;
      const double x = on_left ? middle - part * (middle - left) : middle + part * (right - middle);
      const double there = field(x).value;
      if (there > top) {
        (on_left ? right : left) = std::exchange(middle, x);
        top = there;
      } else {
        (on_left ? left : right) = x;
      }
    }
    const Estimate<double> value = field(middle);
    const double step = scale / 16,
                 bend = (2 * top - field(middle - step).value - field(middle + step).value) / (step * step);
    const double moved = bend > 0 ? value.error / (bend * scale) : infinity<double>();
    peaks.push_back({value, {middle, 1e-7 * scale + moved}});
  }
  if (peaks.empty()) return {field(places.front()), {places.front(), infinity<double>()}};
  const Peak best = *std::max_element(peaks.begin(), peaks.end(),
                                      [](const Peak& a, const Peak& b) { return a.value.value < b.value.value; });
  Peak result = best;
  for (const Peak& other : peaks) {
    // If both are equal, the place is one of them.
    const double less = best.value.value - other.value.value;
    if (less > 1e-12 * best.value.value && less < best.value.error + other.value.error)
      result.x.error = std::max(result.x.error, std::abs(other.x.value - best.x.value));
  }
  return result;
}

}  // namespace

std::vector<InterfaceStress> interface_stresses(const InteriorStress<double>& stress) {
  std::vector<InterfaceStress> result;
  const std::vector<TractionPanel<double>>& panels = stress.traction().panels();
  if (panels.empty()) return result;
  const double left = panels.front().left.high, right = panels.back().right.high;
  for (const double depth : stress.interfaces()) {
    const auto at = [&](double x) {
      StressState<double> state;
      stress.at(std::span(&x, 1), std::span(&depth, 1), std::span(&state, 1));
      return state;
    };
    std::vector<double> places;
    const double step = std::min(depth / 8, (right - left) / 32);
    for (double x = left - 4 * depth; x < right + 4 * depth; x += step) places.push_back(x);
    for (double aside = 4 * depth; aside < 30 * (right - left + depth); aside += std::max(step, aside / 16)) {
      places.insert(places.begin(), left - aside - step);
      places.push_back(right + aside + step);
    }
    const auto shear = highest(places, depth, [&](double x) {
      const Estimate<double> xz = at(x).xz;
      return Estimate<double>{std::abs(xz.value), xz.error};
    });
    const auto tension = highest(places, depth, [&](double x) { return at(x).zz; });
    const bool is_pulled = tension.value.value > 0;
    const Estimate<double> nowhere{std::numeric_limits<double>::quiet_NaN(), infinity<double>()};
    result.push_back(
        {depth, shear.value, shear.x, is_pulled ? tension.value : Estimate<double>{}, is_pulled ? tension.x : nowhere});
  }
  return result;
}

}  // namespace steadyslide::numeric
