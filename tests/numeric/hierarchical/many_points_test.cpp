// Many points in double, summed by cells, are compared with 50 digits, summed one by one.

#include <cmath>
#include <random>

#include "numeric/cauchy/fundamental_solution.hpp"
#include "numeric/cauchy/power_traction.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/quadrature/trapezoidal.hpp"
#include "tests/support/test.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
FundamentalSolution<R> many_points(int panels, double wrong = 0) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<R> lengths;
  std::vector<Power<R>> powers;
  double last = 0.25;
  powers.push_back({R(0.5 - last), R(1.5 - last)});
  for (int k = 0; k < panels; ++k) {
    lengths.push_back(R(std::ldexp(1 + unit(random), -8 - (k % 5) * 3)));
    const double next = unit(random) / 2;
    const double power = k + 1 == panels ? 0.5 + last : last - next;
    powers.push_back({R(power), R(power) + 1});
    last = next;
  }
  powers[3].value += R(wrong);
  return FundamentalSolution<R>(R(-1), std::move(lengths), std::move(powers));
}

constexpr int panels = 200;

double relative(double value, const Real50& exact) {
  using std::abs;
  return static_cast<double>(abs(Real50(value) - exact) / abs(exact)) / epsilon<double>();
}

double worst_modulus(const FundamentalSolution<double>& y) {
  const auto exact = many_points<Real50>(panels);
  double worst = 0;
  for (std::size_t k = 0; k < y.panel_count(); ++k) {
    for (const double part : {1e-12, 0.3, 0.5, 0.999}) {
      const double d = part * y.panel(k).length;
      const Node<double> node = y.panel(k).node_from_left(d);
      const Node<Real50> place = exact.panel(k).node_from_left(Real50(d));
      worst = std::max({worst, relative(y.modulus(k, node), exact.modulus(k, place)),
                        relative(y.smooth_modulus(k, node), exact.smooth_modulus(k, place))});
    }
  }
  for (std::size_t j = 0; j <= y.panel_count(); ++j) {
    worst = std::max(worst, relative(y.amplitude(j), exact.amplitude(j)));
  }
  for (const Side side : {Side::left, Side::right}) {
    for (const double d : {1e-9, 1e-3, 0.1, 10.0}) {
      worst = std::max({worst, relative(y.modulus_beyond(side, d), exact.modulus_beyond(side, Real50(d))),
                        relative(y.smooth_modulus_beyond(side, d), exact.smooth_modulus_beyond(side, Real50(d)))});
    }
  }
  return worst;
}

TEST_CASE("the fundamental solution of 201 points") {
  const auto y = many_points<double>(panels);
  const double worst = worst_modulus(y);
  const Panel<double>& middle = y.panel(panels / 2);
  const double estimate = y.relative_error(panels / 2, middle.node_from_left(middle.length / 2), 0) / epsilon<double>();
  CAPTURE(worst);
  CAPTURE(estimate);
  CHECK(worst <= 300);
  CHECK(worst <= estimate);
  // Control: one power is changed by 1e-11.
  CHECK(worst_modulus(many_points<double>(panels, 1e-11)) > 1000);
}

PiecewiseDensity<double> density_of() {
  PowerTraction<double> traction{many_points<double>(panels), std::vector<double>(panels, -1)};
  PiecewiseDensity<double> density = traction.density();
  density[panels / 2].gap = 0.125;  // the density is arbitrary
  return density;
}

TEST_CASE("principal values on 200 panels, by another rule") {
  const PiecewiseDensity<double> density = density_of();
  const trapezoidal::Grid<double> grid(density);
  for (const std::size_t k : {std::size_t{0}, std::size_t{6}, std::size_t{99}, std::size_t{100}, std::size_t{199}}) {
    for (const double part : {0.25, 0.9}) {
      const PanelPoint<double> at = grid.midpoint_near(k, part);
      const Estimate<double> exact = tanh_sinh::hilbert(density, at);
      const double scale = std::abs(exact.value) + std::abs(density[k](at.node));
      CAPTURE(k);
      CHECK(std::abs(grid.hilbert(at) - exact.value) <= 1e-11 * scale);
      // Control: a neighbouring place differs.
      CHECK(std::abs(grid.hilbert(grid.midpoint_near(k, part - 0.1)) - exact.value) > 1e-6 * scale);
    }
  }
}

TEST_CASE("displacements beside 200 panels are those of two halves, which are summed panel by panel") {
  const PiecewiseDensity<double> density = density_of();
  const auto half = panels / 2;
  PiecewiseDensity<double> last(density.begin() + half, density.end());
  last.front().gap = 0;
  const trapezoidal::Grid<double> whole(density), left({density.begin(), density.begin() + half}), right(last);
  double length = 0;
  for (const auto& panel : last) length += panel.panel.length;
  const auto rise = [](const trapezoidal::Grid<double>& grid, std::size_t k, Side side, double from, double to) {
    return grid.displacement(k, side, to) - (from > 0 ? grid.displacement(k, side, from) : 0);
  };
  constexpr double tolerance = 1e-15;
  for (const double d : {1e-6, 1e-3, 0.05, 0.12}) {
    CAPTURE(d);
    // To the right of all panels, and in the gap: from the left half's end, and from the right half's end.
    const double beyond = rise(right, half - 1, Side::right, 0, d) +
                          rise(left, half - 1, Side::right, 0.125 + length, 0.125 + length + d);
    CHECK(std::abs(whole.displacement(panels - 1, Side::right, d) - beyond) <= tolerance);
    const double inside = rise(left, half - 1, Side::right, 0, d) + rise(right, 0, Side::left, 0.125, 0.125 - d);
    CHECK(std::abs(whole.displacement(half - 1, Side::right, d) - inside) <= tolerance);
    // Control: a neighbouring place differs.
    CHECK(std::abs(whole.displacement(half - 1, Side::right, 1.0001 * d) - inside) > 1000 * tolerance);
  }
}

}  // namespace
}  // namespace steadyslide::numeric
