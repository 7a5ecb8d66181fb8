#include "numeric/layers/symbol_transform.hpp"

#include <stdexcept>

#include "numeric/number/chebyshev.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
constexpr std::size_t legendre_nodes = std::same_as<R, double>   ? 24
                                       : std::same_as<R, Real50> ? 56
                                                                 : 104;

constexpr std::size_t most_panels = 2000;  ///< beside those of given symbols

/// Legendre series through values at Chebyshev's points. The way by Chebyshev's series keeps rounding errors small.
template <Real R>
struct LegendreSeries {
  ChebyshevPoints<R> points{legendre_nodes<R>};
  std::vector<std::vector<R>> rows;  ///< T_m in terms of P_0, ..., P_m

  LegendreSeries() {
    const std::size_t n = legendre_nodes<R>;
    rows.assign(n, std::vector<R>(n + 1, R(0)));
    rows[0][0] = 1;
    rows[1][1] = 1;
    for (std::size_t m = 1; m + 1 < n; ++m) {
      for (std::size_t j = 0; j <= m + 1; ++j) {
        // x P_i = ((i + 1) P_{i+1} + i P_{i-1})/(2i + 1)
        const auto i = static_cast<int>(j);
        const R below = j == 0 ? R(0) : R(rows[m][j - 1] * i / (2 * i - 1));
        rows[m + 1][j] = 2 * (below + rows[m][j + 1] * (i + 1) / (2 * i + 3)) - rows[m - 1][j];
      }
    }
  }

  std::vector<R> coefficients(const std::vector<R>& values) const {
    const std::vector<R> chebyshev = points.series(values);
    std::vector<R> result(chebyshev.size(), R(0));
    for (std::size_t m = 0; m < result.size(); ++m) {
      for (std::size_t j = m % 2; j <= m; j += 2) result[j] += rows[m][j] * chebyshev[m];
    }
    return result;
  }
};

template <Real R>
const LegendreSeries<R>& legendre_series() {
  static const LegendreSeries<R> series;
  return series;
}

/// Returns sin and cos of x y, to the last digit of their absolute value also for large products in double.
template <Real R>
std::pair<R, R> sine_and_cosine(const R& x, const R& y) {
  const R product = x * y;
  const R s = sin(product);
  const R c = cos(product);
  if constexpr (std::same_as<R, double>) {
    const double rest = std::fma(x, y, -product);
    return {s + rest * c, c - rest * s};
  } else {
    return {s, c};
  }
}

}  // namespace

template <Real R>
void spherical_bessel(const R& x, std::vector<R>& j) {
  const std::size_t n = j.size();
  const R first = sin(x) / x;
  const auto size = static_cast<double>(x);
  if (size > static_cast<double>(n)) {
    R below = cos(x) / x;  // j_{-1}
    R value = first;
    for (std::size_t m = 0; m < n; ++m) {
      j[m] = value;
      const R next = static_cast<int>(2 * m + 1) * value / x - below;
      below = value;
      value = next;
    }
    return;
  }
  // Miller's recurrence downwards. It starts where j_m, about x^m/(2m+1)!!, is small against epsilon squared.
  const auto smallest = static_cast<double>(epsilon<R>()) * static_cast<double>(epsilon<R>());
  std::size_t top = 1;
  for (double bound = size / 3; bound > smallest || static_cast<double>(top) < size; ++top) {
    bound *= size / static_cast<double>(2 * top + 3);
  }
  std::fill(j.begin(), j.end(), R(0));
  R above = 0;
  R value = 1;  // j_m up to a factor
  for (std::size_t m = top; m > 0; --m) {
    if (m < n) j[m] = value;
    const R next = static_cast<int>(2 * m + 1) * value / x - above;
    above = value;
    value = next;
  }
  j[0] = value;
  // The factor, by that of j_0 and j_1 which is not near a zero.
  const R second = (first - cos(x)) / x;
  const R factor = size < 1 || abs(first) >= abs(second) ? R(first / value) : R(second / above);
  for (R& entry : j) entry *= factor;
}

template <Real R>
SymbolTransform<R>::SymbolTransform(const BodySymbols<R>& symbols) {
  std::vector<R> cuts = symbols.given_wave_numbers();
  if (cuts.empty() && symbols.last_wave_number() > 0) {
    R end = 1;  // a power of 2, so that products with centres and lengths of panels are exact enough
    while (end < symbols.last_wave_number()) end *= 2;
    while (end / 2 >= symbols.last_wave_number()) end /= 2;
    cuts = {R(0), end};
  }
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) add(symbols, cuts[k], cuts[k + 1], infinity<R>());
}

template <Real R>
void SymbolTransform<R>::add(const BodySymbols<R>& symbols, const R& left, const R& right, const R& tail_before) {
  const LegendreSeries<R>& series = legendre_series<R>();
  Panel panel{(left + right) / 2, (right - left) / 2, {}, {}};
  const R scale = (4 - log(epsilon<R>())) / symbols.last_wave_number();
  R largest = 0;
  std::vector<R> normal;
  std::vector<R> coupling;
  std::vector<R> at_zero;  // integrand of N(0)
  for (std::size_t n = 0; n < series.points.size(); ++n) {
    const R k = panel.centre + panel.half * series.points.place(n);
    const SymbolValues<R> values = symbols.at(k);
    normal.push_back(values.normal_defect);
    coupling.push_back(values.coupling_defect);
    largest = max(largest, R(max(abs(normal.back()), abs(coupling.back()))));
    const R x = k * scale;
    const R rest = x < 1 ? R(expm1(R(-x)) + values.normal) : R(exp(R(-x)) - values.normal_defect);
    at_zero.push_back(rest / k);
  }
  panel.normal = series.coefficients(normal);
  panel.coupling = series.coefficients(coupling);
  const R tolerance = 4 * series_accuracy<R>() * max(R(1), largest);
  const R tail = tail_of(panel.normal, panel.coupling);
  if (!is_exact(tail, tail_before, tolerance)) {
    if (panels_.size() > most_panels + symbols.given_wave_numbers().size()) {
      throw std::runtime_error("the symbols of a body have no Legendre series");
    }
    add(symbols, left, panel.centre, tail);
    add(symbols, panel.centre, right, tail);
    return;
  }
  drop_tail(panel.normal, tolerance);
  drop_tail(panel.coupling, tolerance);
  if (symbols.has_absolute_displacement()) {
    normal_at_zero_ += 2 * panel.half * series.coefficients(at_zero)[0];
    if (panels_.empty()) normal_at_zero_ += log(scale);
  }
  largest_ = max(largest_, largest);
  panels_.push_back(std::move(panel));
}

template <Real R>
typename SymbolTransform<R>::Slopes SymbolTransform<R>::at(const R& y) const {
  Slopes result{R(0), R(0)};
  std::vector<R> bessel(legendre_nodes<R>);
  R known = -1;  // the half length of a panel to which `bessel` belongs
  for (const Panel& panel : panels_) {
    if (panel.half != known) spherical_bessel(R(panel.half * y), bessel);
    known = panel.half;
    const auto [s, c] = sine_and_cosine(panel.centre, y);
    // sum_m c_m i^m j_m
    const auto sum = [&](const std::vector<R>& coefficients, std::size_t from) {
      R total = 0;
      for (std::size_t m = from; m < coefficients.size(); m += 2) {
        const R term = coefficients[m] * bessel[m];
        if (m % 4 < 2) {
          total += term;
        } else {
          total -= term;
        }
      }
      return total;
    };
    const R twice = 2 * panel.half;
    result.normal += twice * (sum(panel.normal, 0) * s + sum(panel.normal, 1) * c);
    result.coupling += twice * (sum(panel.coupling, 0) * c - sum(panel.coupling, 1) * s);
  }
  return result;
}

#define STEADYSLIDE_INSTANTIATE(R)                           \
  template void spherical_bessel(const R&, std::vector<R>&); \
  template class SymbolTransform<R>;
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
