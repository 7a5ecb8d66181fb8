#include "numeric/quadrature/tanh_sinh.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>

namespace steadyslide::numeric::tanh_sinh {
namespace {

/// Powers of epsilon: the smallest abscissa of the rule, and the distance that replaces the end if nearly all of an
/// integral comes from there.
constexpr int least_abscissa = 4, limit_distance = 2;
/// Such an integral has a power p - 1 with p smaller than this.
constexpr double low_power = 0.01;

/// The rule's abscissas. Boost 1.74 cannot compute them down to the smallest MPFR number (its constructor throws). This
/// is not necessary: with the end powers absorbed integrands are bounded, and the part below epsilon^4 is negligible.
template <Real R>
boost::math::quadrature::tanh_sinh<R>& rule() {
  thread_local boost::math::quadrature::tanh_sinh<R> instance(15, pow(epsilon<R>(), R(least_abscissa)));
  return instance;
}

/// Returns int_0^1 f(v) dv for a bounded f that is analytic inside. The type of f is erased, so that Boost's rule is
/// compiled once for each precision. The extra call costs less than a tenth of one power.
template <Real R>
Estimate<R> unit_integral(const std::function<R(const R&)>& f) {
  // Halving the step squares the error of the rule: if two levels agree to sqrt(epsilon), the error is near epsilon.
  // The tolerance is a little smaller than that. Boost stops earlier if its own heuristics detect round-off.
  static const R tolerance = pow(epsilon<R>(), R(0.8));
  static const R sufficient = sqrt(epsilon<R>());
  R error = 0;
  R l1 = 0;
  R value = 0;
  try {
    value = rule<R>().integrate(f, R(0), R(1), tolerance, &error, &l1);
  } catch (const boost::math::evaluation_error&) {
    // The integrand was infinite or NaN. The state is not a solution.
    return {std::numeric_limits<R>::quiet_NaN(), infinity<R>(), Convergence::stalled};
  }
  const bool reached = error <= sufficient * l1;
  return {value, reached ? 16 * epsilon<R>() * l1 : error, reached ? Convergence::reached : Convergence::stalled};
}

/// Returns int_0^h d^lambda g(d) dd.
template <Real R, class G>
Estimate<R> power_integral(const R& h, const Power<R>& power, const G& g) {
  if (power.value == 0) {
    return h * unit_integral<R>([&](const R& v) { return g(h * v); });
  }
  const R inverse = 1 / power.plus_one;
  const R factor = pow(h, power.plus_one) * inverse;
  if (power.plus_one < R(low_power)) {
    // In the variable below, g varies only within 1 + lambda of 1. This is such a small part of the integral that two
    // levels agree before they resolve it. So it is computed here as a separate small integral. At the end itself a
    // density may leave out a term.
    const R limit = g(h * pow(epsilon<R>(), R(limit_distance)));
    const Estimate<R> rest = unit_integral<R>([&](const R& v) { return pow(v, power.value) * (g(h * v) - limit); });
    return factor * (Estimate<R>{limit, R(0)}.widened(16 * epsilon<R>()) + power.plus_one * rest);
  }
  return factor * unit_integral<R>([&](const R& v) { return g(h * pow(v, inverse)); });
}

/// Returns int t(x') kernel(node') dx' over the parts [left, left + h_left] and [right - h_right, right] of a panel.
template <Real R, class Kernel>
Estimate<R> outer_integral(const PanelDensity<R>& density, const R& h_left, const R& h_right, const Kernel& kernel) {
  Estimate<R> sum;
  for (const Side end : {Side::left, Side::right}) {
    sum += power_integral<R>(end == Side::left ? h_left : h_right, density.power(end), [&](const R& d) {
      const Node<R> node = density.panel.node_from(end, d);
      return density.without_power(end, node) * kernel(node);
    });
  }
  return sum;
}

template <Real R, class Kernel>
Estimate<R> whole_integral(const PanelDensity<R>& density, const Kernel& kernel) {
  const R half = density.panel.length / 2;
  return outer_integral<R>(density, half, half, kernel);
}

/// Returns PV int t(x')/(x'-x) dx' over the panel that contains x.
template <Real R>
Estimate<R> own_panel(const PanelDensity<R>& density, const Node<R>& at) {
  const R h_left = at.from_left / 2;
  const R h_right = at.from_right / 2;
  // x' - x is computed from the distances to the end nearer to x, because both are exact there.
  const bool left_is_near = at.from_left < at.from_right;
  Estimate<R> sum = outer_integral<R>(density, h_left, h_right, [&](const Node<R>& node) {
    return 1 / (left_is_near ? node.from_left - at.from_left : at.from_right - node.from_right);
  });
  const R t = density(at);
  for (const int away : {1, -1}) {
    sum += power_integral<R>(away > 0 ? h_right : h_left, {},
                             [&](const R& y) { return y == 0 ? R(0) : away * (density(at.moved(away * y)) - t) / y; });
  }
  sum.value += t * log(at.from_right / at.from_left);
  return sum;
}

}  // namespace

template <Real R>
Estimate<R> panel_integral(const PanelDensity<R>& density) {
  return whole_integral<R>(density, [](const Node<R>&) { return R(1); });
}

template <Real R>
R logarithm(const Power<R>& power) {
  const R of_epsilon = -log(epsilon<R>());
  const R& p = power.plus_one;
  return p < R(low_power) ? R(1 / p + limit_distance * of_epsilon) : R(least_abscissa * of_epsilon / p);
}

template <Real R>
Estimate<R> integral(const PiecewiseDensity<R>& density) {
  Estimate<R> sum;
  for (const PanelDensity<R>& panel : density) sum += panel_integral(panel);
  return sum;
}

template <Real R>
Estimate<R> hilbert(const PiecewiseDensity<R>& density, const PanelPoint<R>& at) {
  Estimate<R> sum = own_panel(density[at.panel], at.node);
  for (std::size_t j = 0; j < density.size(); ++j) {
    if (j == at.panel) continue;
    const bool to_the_right = j > at.panel;
    const R between = (to_the_right ? at.node.from_right : at.node.from_left) + distance_between(density, j, at.panel);
    sum += whole_integral<R>(density[j], [&](const Node<R>& node) {
      return to_the_right ? 1 / (between + node.from_left) : -1 / (between + node.from_right);
    });
  }
  return sum / pi<R>();
}

template <Real R>
Estimate<R> cauchy(const PiecewiseDensity<R>& density, Side side, const R& distance) {
  Estimate<R> sum;
  for (std::size_t j = 0; j < density.size(); ++j) {
    const std::size_t nearest = side == Side::left ? 0 : density.size() - 1;
    R between = distance;
    if (j != nearest) between += density[nearest].panel.length + distance_between(density, nearest, j);
    sum += whole_integral<R>(density[j], [&](const Node<R>& node) {
      return side == Side::left ? 1 / (between + node.from_left) : -1 / (between + node.from_right);
    });
  }
  return sum / pi<R>();
}

#define STEADYSLIDE_INSTANTIATE(R)                                                \
  template Estimate<R> panel_integral(const PanelDensity<R>&);                    \
  template R logarithm(const Power<R>&);                                          \
  template Estimate<R> integral(const PiecewiseDensity<R>&);                      \
  template Estimate<R> hilbert(const PiecewiseDensity<R>&, const PanelPoint<R>&); \
  template Estimate<R> cauchy(const PiecewiseDensity<R>&, Side, const R&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric::tanh_sinh
