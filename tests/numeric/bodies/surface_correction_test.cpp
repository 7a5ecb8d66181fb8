// The corrections of a body's surface, and its kernel on cells, against their definitions.

#include "numeric/layers/surface_correction.hpp"

#include "numeric/periodic/periodic_problems.hpp"
#include "numeric/variational/surface_kernel.hpp"

using namespace numeric;

TEST_CASE_TEMPLATE("with a period the kernel is the sum over all periods, and its slope is that of the operator", R,
                   double, Real50) {
  const ContactProblem problem = periodic(1.5_r, {0.25_r}, {}, flat(-0.5_r, 0.5_r));
  const R L(1.5);
  const auto correction = surface_correction<R>(problem, L);
  for (const Rational& place : {-1.25_r, -0.375_r, 0.0001_r, 0.5_r, 0.75_r, 1.4375_r}) {
    const R y = to_real<R>(place);
    // prod (1 - y^2/(kL)^2) = sin(pi y/L)/(pi y/L): the logarithms of all other periods, up to the order K^-5.
    constexpr int K = 400;
    R sum = 0;
    for (int k = 1; k <= K; ++k) sum -= log(1 - y * y / (k * L * k * L));
    const R q = y * y / (L * L), n = R(K) + R(1) / 2;
    sum += q * (1 / n - 1 / (12 * n * n * n)) + q * q / (6 * n * n * n);
    CHECK(size_of(R(correction->normal(y) - sum)) < 1e-11);
    const R slope = 1 / y - pi<R>() / L / tan(pi<R>() * y / L);
    CHECK(size_of(R(correction->normal_slope(y) - slope)) < 32 * epsilon<R>() * (1 + 1 / size_of(y)));
    CHECK(close<R>(correction->coupling(y), correction->coupling_slope(y) * y, 4));
  }
  CHECK(correction->normal_slope(R(0)) == 0);
  CHECK(close<R>(correction->coupling_slope(R(0)), pi<R>() * to_real<R>(problem.elasticity().gamma()) / L, 4));
}

namespace {

const Solid soft(0.3_r, 1);

ContactProblem on(const Body& body) {
  return ContactProblem(Elasticity(soft), FrictionProfile({0.5_r}), one_piece(-1, 1, {0}), 1).with_body(body);
}

/// The mean of f over two cells of length h, by a rule that no kernel uses. `rule(v)` is f at the distance y + v.
double mean_of_cells(const Rational& h, const std::function<double(const Rational&)>& f) {
  constexpr int parts = 32;
  const auto part = [&](const Rational& from, const Rational& to) {
    return integral<double>(from, to, [&](const Rational& v) { return to_real<double>(h - abs(v)) * f(v); });
  };
  double sum = 0;
  for (int k = -parts; k < parts; ++k) sum += part(h * k / parts, h * (k + 1) / parts);
  return sum / to_real<double>(h * h);
}

}  // namespace

TEST_CASE("entries of equal cells are means of the kernel, also with cells longer than the layer") {
  const std::vector<Body> bodies{Body::layered({{0.2_r, soft}}, std::nullopt),
                                 Body::layered({{1, soft}}, Solid(0.2_r, 9)),
                                 Body::layered({{0.01_r, soft, Interface::slip}}, std::nullopt), Body::periodic(2)};
  const double pi = std::numbers::pi;
  for (const Body& body : bodies) {
    const ContactProblem problem = on(body);
    const std::shared_ptr<const SurfaceCorrection<double>> correction = surface_correction<double>(problem, 3);
    const variational::SurfaceKernel kernel(correction, 2, 0.5);
    // The constant of the kernel, from one value.
    const double constant = pi * kernel.at(0.25) + std::log(0.25) - correction->normal(0.5);
    for (const Rational& h : {0.01_r, 0.125_r}) {
      const auto cell = to_real<double>(h);
      for (const int k : {0, 1, 3, 7}) {
        const double mean = mean_of_cells(h, [&](const Rational& v) {
          const auto y = to_real<double>(abs(k * h + v));
          return correction->normal(2 * y) - std::log(y);
        });
        const double entry = kernel.mean_of_equal_cells(cell, static_cast<std::size_t>(k));
        CHECK(entry == doctest::Approx(cell * (mean + constant) / pi).epsilon(1e-12));
        const double turning =
            mean_of_cells(h, [&](const Rational& v) { return correction->coupling(2 * to_real<double>(k * h + v)); });
        CHECK(std::abs(kernel.coupling_of_equal_cells(cell, k) + cell * turning / pi) < 1e-14);
      }
    }
  }
}

TEST_CASE("on the circle the last cell is the first one's neighbour") {
  const variational::SurfaceKernel kernel(surface_correction<double>(on(Body::periodic(2)), 3), 2, 0.5);
  for (const std::size_t n : {4U, 10U, 64U}) {
    const double h = 1 / static_cast<double>(n);
    for (std::size_t k = 1; k < n; ++k) {
      CHECK(kernel.mean_of_equal_cells(h, k) == doctest::Approx(kernel.mean_of_equal_cells(h, n - k)).epsilon(1e-13));
      const double from = kernel.from_equal_cell(h, static_cast<double>(k));
      CHECK(from == doctest::Approx(kernel.from_equal_cell(h, static_cast<double>(n - k))).epsilon(1e-13));
    }
    CHECK(std::abs(kernel.mean_of_equal_cells(h, 1) - kernel.mean_of_equal_cells(h, n / 2)) > 0.1 * h);
  }
}
