#include "numeric/layers/symbol_transform.hpp"

#include "numeric/quadrature/jacobi_rule.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
constexpr std::size_t legendre_nodes = std::same_as<R, double>   ? 24
                                       : std::same_as<R, Real50> ? 56
                                                                 : 104;

constexpr int most_panel_halvings = 50;

/// Gauss' rule on [-1, 1], and the numbers that make Legendre coefficients of values at its nodes.
template <Real R>
struct LegendreRule {
  std::vector<R> places;
  std::vector<R> weights;
  std::vector<std::vector<R>> rows;  ///< row m: weight (2m + 1)/2 P_m(place)

  LegendreRule() {
    const UnitRule<R> unit = jacobi_rule<R>({}, {}, static_cast<int>(legendre_nodes<R>));
    rows.assign(legendre_nodes<R>, std::vector<R>(legendre_nodes<R>));
    for (std::size_t k = 0; k < legendre_nodes<R>; ++k) {
      const R x = unit.from_left[k] - unit.from_right[k];
      places.push_back(x);
      weights.push_back(2 * unit.weights[k]);
      R before = 0;
      R value = 1;  // P_m
      for (std::size_t m = 0; m < legendre_nodes<R>; ++m) {
        const auto degree = static_cast<int>(m);
        rows[m][k] = weights[k] * (2 * degree + 1) / 2 * value;
        const R next = ((2 * degree + 1) * x * value - degree * before) / (degree + 1);
        before = value;
        value = next;
      }
    }
  }

  /// The nodes are rounded, so that a constant part would leave errors in all coefficients.
  std::vector<R> coefficients(const std::vector<R>& values) const {
    const R constant = values[values.size() / 2];
    std::vector<R> result;
    for (const std::vector<R>& row : rows) {
      R sum = 0;
      for (std::size_t k = 0; k < row.size(); ++k) sum += row[k] * (values[k] - constant);
      result.push_back(sum);
    }
    result[0] += constant;
    return result;
  }
};

template <Real R>
const LegendreRule<R>& legendre_rule() {
  static const LegendreRule<R> rule;
  return rule;
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
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) add(symbols, cuts[k], cuts[k + 1], 0);
}

template <Real R>
void SymbolTransform<R>::add(const BodySymbols<R>& symbols, const R& left, const R& right, int halvings) {
  const LegendreRule<R>& rule = legendre_rule<R>();
  Panel panel{(left + right) / 2, (right - left) / 2, {}, {}};
  const R scale = (4 - log(epsilon<R>())) / symbols.last_wave_number();
  R at_zero = 0;
  R largest = 0;
  std::vector<R> normal;
  std::vector<R> coupling;
  for (std::size_t n = 0; n < rule.places.size(); ++n) {
    const R k = panel.centre + panel.half * rule.places[n];
    const SymbolValues<R> values = symbols.at(k);
    normal.push_back(values.normal_defect);
    coupling.push_back(values.coupling_defect);
    largest = max(largest, R(max(abs(normal.back()), abs(coupling.back()))));
    const R x = k * scale;
    const R rest = x < 1 ? R(expm1(R(-x)) + values.normal) : R(exp(R(-x)) - values.normal_defect);
    at_zero += rule.weights[n] * rest / k;
  }
  panel.normal = rule.coefficients(normal);
  panel.coupling = rule.coefficients(coupling);
  const R tolerance = 16 * epsilon<R>() * max(R(1), largest);
  const bool resolved = drop_tail(panel.normal, tolerance) >= 2 && drop_tail(panel.coupling, tolerance) >= 2;
  if (!resolved && halvings < most_panel_halvings) {
    add(symbols, left, panel.centre, halvings + 1);
    add(symbols, panel.centre, right, halvings + 1);
    return;
  }
  if (symbols.has_absolute_displacement()) normal_at_zero_ += panel.half * at_zero;
  if (panels_.empty() && symbols.has_absolute_displacement()) normal_at_zero_ += log(scale);
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
