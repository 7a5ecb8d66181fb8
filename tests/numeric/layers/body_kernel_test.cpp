// Kernels against quadratures of the integrals that define them. The quadratures use the closed formula of a layer, or
// symbols alone, and no table.

#include "numeric/layers/body_kernel.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <chrono>

#include "numeric/layers/symbol_transform.hpp"
#include "support/numeric_test.hpp"

namespace {

const Solid hard(0.3_r, 2000_r);
const Solid soft(0.45_r, 2_r);

template <Real R>
struct Kernel {
  BodySymbols<R> symbols;
  BodyKernel<R> kernel;
  Kernel(const Body& body, const R& reach)
      : symbols(Elasticity(body.layers()[0].solid), body), kernel(symbols, reach) {}
};

Body on_rigid(const Solid& solid, const Rational& h) { return Body::layered({{h, solid}}, std::nullopt); }

/// Returns int_0^end f(k) dk by Gauss' rule on panels of length `step`, the first ones graded towards 0.
template <Real R, class F>
R integrated(const F& f, const R& end, const R& step) {
  R sum = 0;
  R from = 0;
  for (R to = step / 4096; from < end; to = min(end, R(from + min(step, R(3 * from))))) {
    sum += boost::math::quadrature::gauss < R, std::same_as<R, double> ? 20 : 50 > ::integrate(f, from, to);
    from = to;
  }
  return sum;
}

template <Real R>
R by_quadrature(const BodySymbols<R>& symbols, const R& y, bool normal) {
  const auto slope = [&](const R& k) {
    const auto values = symbols.at(k);
    return R(normal ? values.normal_defect * sin(R(k * y)) : values.coupling_defect * cos(R(k * y)));
  };
  return integrated<R>(slope, symbols.last_wave_number(), R(std::same_as<R, double> ? 1 : 4) / (1 + abs(y)));
}

/// The closed formula of a bonded layer on a rigid base: 1 - W, from exp(-2 xi) alone.
template <Real R>
R closed_defect(const R& kappa, const R& xi) {
  const R e = exp(R(-2 * xi));
  return (2 * kappa * e * e + (1 + kappa * kappa + 4 * xi * xi + 4 * xi) * e) /
         (kappa * (1 + e * e) + (1 + kappa * kappa + 4 * xi * xi) * e);
}

}  // namespace

TEST_CASE_TEMPLATE("spherical Bessel functions: the sum of squares, and the standard library's", R, double, Real50) {
  std::vector<R> j(60);
  for (const double x : {1e-9, 1e-3, 0.7, 3.0, 9.42477796, 29.9, 30.1, 1e4}) {
    spherical_bessel(R(x), j);
    CHECK(close(j[0], R(sin(R(x)) / x), 20, R(1)));
    if (std::same_as<R, double> && x < 100) {
      for (unsigned m = 0; m < 30; ++m) CHECK(std::abs(double(j[m]) - std::sph_bessel(m, x)) < 4e-14);
    }
    if (x > 12) continue;
    R sum = 0;
    for (int m = 0; m < 60; ++m) sum += (2 * m + 1) * j[static_cast<std::size_t>(m)] * j[static_cast<std::size_t>(m)];
    CHECK(close(sum, R(1), 100));
  }
}

TEST_CASE_TEMPLATE("a bonded layer on a rigid base: slopes and values by the closed formula", R, double, Real50) {
  const auto [symbols, kernel] = Kernel<R>(on_rigid(hard, 0.5_r), R(5));
  const R kappa = to_real<R>(hard.kolosov(Plane::strain));
  const R tolerance = std::same_as<R, double> ? R(1e-14) : R(1e-50);
  const R end = symbols.last_wave_number();
  const auto defect = [&](const R& k) { return closed_defect<R>(kappa, R(k / 2)); };
  // N(0) = int_0^1 W/k dk - int_1^oo (1 - W)/k dk - Euler's constant.
  const R below = integrated<R>([&](const R& k) { return R((1 - defect(k)) / k); }, R(1), R(1));
  const R above = integrated<R>([&](const R& k) { return R(defect(k + 1) / (k + 1)); }, end, R(1));
  const R at_zero = below - above - boost::math::constants::euler<R>();
  CHECK(size_of(R(kernel.normal().at(0) - at_zero)) < 10 * tolerance);
  for (const double place : {1e-3, 0.2, 1.0, 1.7, 4.9}) {
    const R y = place;
    const R step = R(1) / (1 + y);
    CHECK(size_of(R(kernel.normal_slope().at(y) -
                    integrated<R>([&](const R& k) { return R(defect(k) * sin(R(k * y))); }, end, step))) < tolerance);
    CHECK(size_of(R(kernel.coupling_slope().at(y) - by_quadrature(symbols, y, false))) < tolerance);
    const R rise = integrated<R>(
        [&](const R& k) {
          const R half = sin(R(k * y / 2));
          return R(defect(k) * 2 * half * half / k);
        },
        end, step);
    CHECK(size_of(R(kernel.normal().at(y) - at_zero - rise)) < 10 * tolerance);
    const R coupled = integrated<R>(
        [&, &symbols = symbols](const R& k) { return R(symbols.at(k).coupling_defect * sin(R(k * y)) / k); }, end,
        step);
    CHECK(size_of(R(kernel.coupling().at(y) - coupled)) < 10 * tolerance);
    CHECK(kernel.normal().at(-y) == kernel.normal().at(y));
    CHECK(kernel.coupling().at(-y) == -kernel.coupling().at(y));
  }
}

TEST_CASE("far from the load: nothing is left on a rigid base, and the base on an elastic one") {
  for (const auto& [h, tolerance] : {std::pair(0.1_r, 2e-5), {0.02_r, 3e-15}, {0.001_r, 1e-14}, {0.0001_r, 2e-14}}) {
    const auto [symbols, kernel] = Kernel<double>(on_rigid(hard, h), 1.0);
    REQUIRE(kernel.is_absolute());
    CHECK(std::abs(kernel.normal().at(1)) < tolerance);
    CHECK(std::abs(kernel.normal().at(0.7) - std::log(0.7)) < 20 * tolerance);
    CHECK(std::abs(kernel.coupling().at(1) - symbols.gamma() * std::numbers::pi / 2) < 2 * tolerance);
  }
  const auto [symbols, kernel] = Kernel<double>(Body::layered({{0.001_r, soft}}, hard), 100.0);
  const double at_zero = symbols.normal(1e-12);
  const double coupling_at_zero = symbols.coupling(1e-12);
  CHECK(at_zero < 0.01);
  CHECK_FALSE(kernel.is_absolute());
  CHECK(kernel.normal().at(0) == 0);
  CHECK(100 * kernel.normal_slope().at(100) == doctest::Approx(1 - at_zero).epsilon(1e-4));
  CHECK(kernel.coupling().at(100) ==
        doctest::Approx((symbols.gamma() - coupling_at_zero) * std::numbers::pi / 2).epsilon(1e-3));
  // A layer of the base's own solid, and the half-plane.
  const auto same = Kernel<double>(Body::layered({{0.5_r, hard}}, hard), 3.0);
  CHECK(std::abs(same.kernel.normal().at(2)) < 1e-14);
  const BodyKernel<double> none(BodySymbols<double>(Elasticity(hard), Body{}), 1.0);
  CHECK(none.normal().at(0.3) == 0);
}

TEST_CASE("stacks, slip and contrast: slopes by quadrature of the symbols") {
  for (const Body& body : {Body::layered({{0.5_r, soft, Interface::slip}}, hard),
                           Body::layered({{0.5_r, hard, Interface::slip}}, std::nullopt),
                           Body::layered({{0.2_r, hard}, {1_r, soft}}, hard),
                           Body::layered({{0.5_r, soft}, {0.01_r, hard, Interface::slip}, {1_r, soft}}, soft)}) {
    const auto [symbols, kernel] = Kernel<double>(body, 20.0);
    const double size = std::abs(kernel.normal_slope().at(1)) + std::abs(kernel.coupling_slope().at(0));
    for (const double y : {0.01, 0.7, 3.0, 19.0}) {
      CAPTURE(y);
      CHECK(std::abs(kernel.normal_slope().at(y) - by_quadrature(symbols, y, true)) < 1e-14 * (1 + size));
      CHECK(std::abs(kernel.coupling_slope().at(y) - by_quadrature(symbols, y, false)) < 1e-14 * (1 + size));
    }
  }
}

TEST_CASE("random stacks: the tables exist and agree with the integrals") {
  REQUIRE(rc::check([] {
    const auto solid = [] { return Solid(Rational(uniform(-90, 49)) / 100, Rational(std::pow(10.0, uniform(-2, 2)))); };
    std::vector<Layer> layers;
    const int count = uniform(1, 4);
    for (int n = 0; n < count; ++n) {
      const Rational thickness(std::pow(10.0, uniform(-30, 10) / 10.0));
      layers.push_back({thickness, solid(), uniform(0, 1) == 0 ? Interface::bonded : Interface::slip});
    }
    const Body body = Body::layered(layers, uniform(0, 1) == 0 ? std::nullopt : std::optional(solid()));
    const auto [symbols, kernel] = Kernel<double>(body, 1.0);
    const double y = std::pow(10.0, uniform(-400, 0) / 100.0);
    const SymbolTransform<double> transform(symbols);
    const auto direct = transform.at(y);
    const double size = std::abs(direct.normal) + std::abs(direct.coupling) +
                        (1 + transform.largest_defect()) / (y + to_real<double>(layers[0].thickness));
    RC_ASSERT(std::abs(kernel.normal_slope().at(y) - direct.normal) < 1e-12 * size);
    RC_ASSERT(std::abs(kernel.coupling_slope().at(y) - direct.coupling) < 1e-12 * size);
  }));
}

TEST_CASE("a smooth pressure displaces the surface as its transform says, in sign and size") {
  // p = exp(-x^2), s = gamma f, f = 1/2: -u/c = (1/pi) int_0^oo (W cos(kx) + s V sin(kx)) sqrt(pi) exp(-k^2/4)/k dk.
  const auto [symbols, kernel] = Kernel<double>(on_rigid(hard, 0.7_r), 20.0);
  const double f = 0.5;
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  for (const double x : {-1.3, 0.0, 0.4, 2.0}) {
    const auto transform = [&, &symbols = symbols](double k) {
      const double p = std::sqrt(std::numbers::pi) * std::exp(-k * k / 4);
      return (symbols.normal(k) * std::cos(k * x) + f * symbols.coupling(k) * std::sin(k * x)) * p / k;
    };
    const auto pressure = [](double place) { return std::exp(-place * place); };
    // d = x' - x, both signs of d together; log d is integrated in v = sqrt(d).
    const auto source = [&, &symbols = symbols, &kernel = kernel](double v) {
      const double d = v * v;
      const double even = pressure(x + d) + pressure(x - d);
      const double odd = pressure(x + d) - pressure(x - d);
      return 2 * v *
             (even * (kernel.normal().at(d) - std::log(d)) +
              f * odd * (kernel.coupling().at(d) - symbols.gamma() * std::numbers::pi / 2));
    };
    const double found = Rule::integrate(source, 1e-30, std::sqrt(9.0), 12, 1e-13);
    CHECK(found == doctest::Approx(Rule::integrate(transform, 1e-9, 14.0, 12, 1e-13)).epsilon(1e-9));
  }
}

TEST_CASE("scaled bodies, given symbols, refusals, time") {
  const Body body = Body::layered({{0.2_r, hard}, {1_r, soft}}, std::nullopt);
  const auto one = Kernel<double>(body, 1.0);
  const auto large = Kernel<double>(body.scaled(8), 8.0);
  for (const double y : {0.0, 0.1, 0.9}) {
    CHECK(large.kernel.normal().at(8 * y) == doctest::Approx(one.kernel.normal().at(y) + std::log(8.0)).epsilon(1e-13));
    CHECK(large.kernel.coupling().at(8 * y) == doctest::Approx(one.kernel.coupling().at(y)).epsilon(1e-13));
  }
  std::vector<SymbolRow> rows;
  for (int n = 1; n <= 200; ++n) {
    const double k = n / 8.0;
    rows.push_back({Rational(k), Rational(one.symbols.normal(k)), Rational(one.symbols.coupling(k))});
  }
  const BodySymbols<double> given(Elasticity(hard), Body::of_symbols(rows));
  const BodyKernel<double> table(given, 1.0);
  for (const double y : {0.02, 0.3, 1.0}) {
    CHECK(table.normal().at(y) == doctest::Approx(one.kernel.normal().at(y)).epsilon(1e-2));
    double sum = 0;
    for (int n = 0; n < 200; ++n) {
      sum += boost::math::quadrature::gauss<double, 15>::integrate(
          [&](double k) { return given.at(k).normal_defect * std::sin(k * y); }, n / 8.0, (n + 1) / 8.0);
    }
    CHECK(std::abs(table.normal_slope().at(y) - sum) < 1e-12);
  }
  CHECK(holds(thrown_by([&] { BodyKernel<double>(one.symbols, 0.0); }), "reach"));
  const auto start = std::chrono::steady_clock::now();
  Kernel<Real50>(on_rigid(hard, 0.1_r), Real50(1));
  CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 10);
}
