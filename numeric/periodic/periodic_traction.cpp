#include "numeric/periodic/periodic_traction.hpp"

#include <array>

#include "numeric/quadrature/tanh_sinh.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
Complex<R> complex_product(const Complex<R>& a, const Complex<R>& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

template <Real R>
Complex<R> unit_complex(const R& angle) {
  return {cos(angle), sin(angle)};
}

/// The expansion of Y times the phase, factor q^-m sum_i series_i q^{2i}, at +i oo.
template <Real R>
struct PeriodicExpansion {
  Complex<R> factor;
  std::vector<Complex<R>> series;

  PeriodicExpansion(const PeriodicTraction<R>& traction, int m, std::size_t terms) : series(terms) {
    const PeriodicFundamentalSolution<R>& weight = traction.weight;
    // sin(y (z - e))^p = (i/2)^p e^{i y p e} q^-p (1 - q^2 e^{-2iye})^p.
    R angle = 0;
    for (std::size_t j = 0; j < weight.size(); ++j) angle += weight.power(j).value * weight.point(j);
    factor = unit_complex<R>(weight.wave_number() * angle);
    for (int k = 0; k < (m + 4) % 4; ++k) factor = complex_product(factor, {R(0), R(1)});
    for (R* part : {&factor.re, &factor.im}) *part = ldexp(*part, -m);
    factor = complex_product(factor, traction.phase);
    std::vector<Complex<R>> sums(terms);
    for (std::size_t k = 1; k < terms; ++k) {
      for (std::size_t j = 0; j < weight.size(); ++j) {
        const Complex<R> power = unit_complex<R>(-2 * static_cast<double>(k) * weight.wave_number() * weight.point(j));
        sums[k].re += weight.power(j).value * power.re;
        sums[k].im += weight.power(j).value * power.im;
      }
    }
    series[0] = {R(1), R(0)};
    for (std::size_t n = 1; n < terms; ++n) {
      for (std::size_t k = 1; k <= n; ++k) {
        const Complex<R> term = complex_product(sums[k], series[n - k]);
        series[n].re -= term.re / static_cast<double>(n);
        series[n].im -= term.im / static_cast<double>(n);
      }
    }
  }

  /// Returns the coefficient of q^{-2n} in Y T times the phase.
  Complex<R> coefficient(const PeriodicTraction<R>& traction, int m, int n) const {
    Complex<R> sum{R(0), R(0)};
    for (std::size_t i = 0; i < traction.tau.size(); ++i) {
      const int k = traction.parity + 2 * static_cast<int>(i);
      const auto add = [&](int index, const Complex<R>& tau) {
        if (index < 0) return;
        const Complex<R> term = complex_product(series[static_cast<std::size_t>(index)], tau);
        sum.re += term.re;
        sum.im += term.im;
      };
      add((m + k) / 2 - n, traction.tau[i]);
      if (k > 0 && m >= k) add((m - k) / 2 - n, {traction.tau[i].re, -traction.tau[i].im});
    }
    return complex_product(factor, sum);
  }
};

/// Returns the load and the closure, of which both are linear functions of tau.
template <Real R>
std::array<R, 2> conditions_of(const PeriodicTraction<R>& traction, const std::vector<R>& s, int m) {
  const Complex<R> constant = PeriodicExpansion<R>(traction, m, traction.tau.size() + 1).coefficient(traction, m, 0);
  const R period = traction.weight.period(), load = -period * constant.im;
  R friction = s.back() * load;
  for (std::size_t k = 0; k + 1 < s.size(); ++k) {
    const R difference = s[k] - s.back();
    if (difference != 0) friction -= difference * tanh_sinh::panel_integral(traction.density(k)).value;
  }
  return {load, constant.re - friction / period};
}

}  // namespace

template <Real R>
std::pair<R, R> PeriodicTraction<R>::polynomial(const R& x) const {
  const R angle = weight.wave_number() * x;
  const Complex<R> step = unit_complex<R>(-2 * angle);
  Complex<R> power = parity == 0 ? Complex<R>{R(1), R(0)} : unit_complex<R>(-angle);
  R sum = 0, size = 0;
  for (std::size_t i = 0; i < tau.size(); ++i) {
    const int times = parity == 0 && i == 0 ? 1 : 2;
    sum += times * (tau[i].re * power.re - tau[i].im * power.im);
    size += times * (abs(tau[i].re) + abs(tau[i].im));
    power = complex_product(power, step);
  }
  return {sum, size};
}

template <Real R>
R PeriodicTraction<R>::value(std::size_t k, const R& from_left, const R& from_right, bool without_left,
                             bool without_right) const {
  const bool from_last = k + 1 == weight.size();
  const R x = from_left < from_right || from_last ? weight.point(k) + from_left : weight.point(k + 1) - from_right;
  const R factor = k == gap() ? phase.re : R(-cosines[k]);
  return factor * weight.modulus(k, from_left, from_right, without_left, without_right) * polynomial(x).first;
}

template <Real R>
PanelDensity<R> PeriodicTraction<R>::density(std::size_t k, const R& from_left, const R& from_right) const {
  const R left = weight.point(k) + from_left, length = weight.arc(k) - (from_left + from_right);
  const bool at_left = from_left == 0, at_right = from_right == 0;
  return {{left, left + length, length},
          at_left ? weight.power(k) : Power<R>{},
          at_right ? weight.power(k + 1) : Power<R>{},
          [=, this](const Node<R>& node) {
            return value(k, from_left + node.from_left, from_right + node.from_right, at_left, at_right);
          }};
}

template <Real R>
PeriodicState<R> periodic_state(PeriodicZone<R> zone) {
  PeriodicState<R> state{std::move(zone.traction), R(0), R(0)};
  PeriodicTraction<R>& traction = state.traction;
  const int m = zone.m, harmonics = static_cast<int>(zone.g.size());
  traction.parity = m == 0 ? 0 : 1;
  traction.tau.assign(static_cast<std::size_t>(harmonics + (1 - m) / 2 + (m == 0 ? 1 : 0)), {R(0), R(0)});
  const PeriodicExpansion<R> expansion(traction, m, zone.g.size() + 1);
  const R size = expansion.factor.re * expansion.factor.re + expansion.factor.im * expansion.factor.im;
  const Complex<R> inverse{expansion.factor.re / size, -expansion.factor.im / size};
  for (int n = harmonics; n > 0; --n) {
    const Complex<R> known = expansion.coefficient(traction, m, n);
    const Complex<R>& g = zone.g[static_cast<std::size_t>(n - 1)];
    const Complex<R> rest{-known.re - g.re / 2, -known.im - g.im / 2};
    traction.tau[static_cast<std::size_t>((2 * n - m) / 2)] = complex_product(rest, inverse);
  }

  const auto of_last_term = [&](const Complex<R>& last) {
    const PeriodicTraction<R> whole = traction;
    for (Complex<R>& tau : traction.tau) tau = {R(0), R(0)};
    traction.tau[0] = last;
    const std::array<R, 2> result = conditions_of(traction, zone.s, m);
    traction.tau = whole.tau;
    return result;
  };
  const std::array<R, 2> known = conditions_of(traction, zone.s, m);
  if (m == 1) {
    state.load = known[0];
    state.closure = known[1];
  } else if (m == 0) {
    const std::array<R, 2> one = of_last_term({R(1), R(0)});
    traction.tau[0].re = traction.has_gap() ? R(-known[1] / one[1]) : R((zone.load - known[0]) / one[0]);
    state.load = known[0] + traction.tau[0].re * one[0];
  } else {
    const std::array<R, 2> re = of_last_term({R(1), R(0)}), im = of_last_term({R(0), R(1)});
    const R determinant = re[0] * im[1] - re[1] * im[0];
    const R load = zone.load - known[0], closure = -known[1];
    traction.tau[0] = {(load * im[1] - closure * im[0]) / determinant, (re[0] * closure - re[1] * load) / determinant};
    state.load = zone.load;
  }
  return state;
}

#define STEADYSLIDE_INSTANTIATE(R)     \
  template struct PeriodicTraction<R>; \
  template PeriodicState<R> periodic_state(PeriodicZone<R>);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
