#pragma once
// The supremum of the pressure: if it is infinite, from the singular points; otherwise the highest peak.

#include "numeric/solution/contact_solution.hpp"
#include "numeric/solution/highest_peak.hpp"

namespace steadyslide::numeric {

/// Returns the place where the traction blows up, by a power below 0 or by a logarithm, also if its intensity is
/// unknown. Absent if it blows up nowhere. Exponents are compared exactly; of intensities that are equal within their
/// errors the leftmost counts.
template <Real R>
std::optional<LargestPressure<R>> infinite_pressure(const std::vector<SolvedSingularPoint<R>>& points) {
  const auto order = [](const SolvedSingularPoint<R>& a, const SolvedSingularPoint<R>& b) {
    const auto power = [](const SolvedSingularPoint<R>& point) { return point.exponent.value_or(Exponent()); };
    const R difference = to_real<R>(power(a)) - to_real<R>(power(b));
    using std::abs;
    if (abs(difference) > 8 * epsilon<R>()) return difference < 0 ? -1 : 1;
    return (power(a) - power(b)).sign();
  };
  const SolvedSingularPoint<R>* worst = nullptr;
  for (const SolvedSingularPoint<R>& point : points) {
    if (!local_terms(point.kind).is_infinite(point.exponent)) continue;
    // A power has a positive intensity; a logarithm may have none.
    if (!point.exponent && !(point.intensity.value > 0) && !isinf(point.intensity.error)) continue;
    const auto is_worse = [&] {
      if (const int compared = order(point, *worst); compared != 0) return compared < 0;
      return point.intensity.value - point.intensity.error > worst->intensity.value + worst->intensity.error;
    };
    if (worst == nullptr || is_worse()) worst = &point;
  }
  if (worst == nullptr) return std::nullopt;
  return LargestPressure<R>{{infinity<R>(), R(0)}, worst->x, worst->exponent};
}

/// Returns the highest peak of the pressure on panels of these lengths, with its place from `x_of`; `known` if no peak
/// is higher. The error of the place covers other peaks that may be the highest.
template <Real R>
LargestPressure<R> finite_pressure(const LargestPressure<R>& known, const std::vector<R>& lengths,
                                   const PanelFunction<R>& pressure,
                                   const std::function<Estimate<R>(const Peak<R>&)>& x_of) {
  const std::vector<Peak<R>> peaks = highest_peaks(lengths, pressure, known.value.value);
  if (peaks.empty()) return known;
  Estimate<R> x = x_of(peaks[0]);
  for (const Peak<R>& peak : peaks) {
    const Estimate<R> other = x_of(peak);
    x.error = max(x.error, abs(other.value - x.value) + other.error);
  }
  return {peaks[0].value, x, std::nullopt};
}

}  // namespace steadyslide::numeric
