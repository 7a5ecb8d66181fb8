#include "numeric/periodic/periodic_kernel.hpp"

#include "periodic_problems.hpp"

using namespace numeric;

TEST_CASE_TEMPLATE("the kernel is the sum over all periods, and its slope is that of the operator", R, double, Real50) {
  const Rational period = 1.5_r;
  const R L = to_real<R>(period);
  const PeriodicKernel<R> kernel(L, R(0.25));
  for (const Rational& place : {-1.25_r, -0.375_r, 0.0001_r, 0.5_r, 0.75_r, 1.4375_r}) {
    const R y = to_real<R>(place);
    // prod (1 - y^2/(kL)^2) = sin(pi y/L)/(pi y/L): the logarithms of all other periods, up to the order K^-5.
    constexpr int K = 400;
    R sum = -log(2 * pi<R>() / L);
    for (int k = 1; k <= K; ++k) sum -= log(1 - y * y / (k * L * k * L));
    const R q = y * y / (L * L), n = R(K) + R(1) / 2;
    sum += q * (1 / n - 1 / (12 * n * n * n)) + q * q / (6 * n * n * n);
    CHECK(size_of(R(kernel.normal(y) - sum)) < 1e-11);
    const R slope = 1 / y - pi<R>() / L / tan(pi<R>() * y / L);
    CHECK(size_of(R(kernel.normal_slope(y) - slope)) < 32 * epsilon<R>() * (1 + 1 / size_of(y)));
    CHECK(kernel.coupling(y) == kernel.coupling_slope() * y);
  }
  CHECK(kernel.normal_slope(R(0)) == 0);
  CHECK(close<R>(kernel.coupling(L), R(pi<R>() / 4), 4));
}

TEST_CASE_TEMPLATE("means over two cells, up to the next period", R, double, Real50) {
  const PeriodicKernel<R> kernel(R(2), R(0));
  const Rational h = 0.0625_r;
  const auto N = [](const Rational& y) -> R {
    const Rational distance = abs(y), next = 2 - distance;  // the distance from the next period, exactly
    return log(to_real<R>(distance)) - log(2 * sin(pi<R>() / 2 * to_real<R>(std::min(distance, next))));
  };
  for (const int k : {0, 1, 3, 15, 16, 17, 28, 30, 31}) {
    const auto part = [&](const Rational& from, const Rational& to) {
      return integral<R>(from, to, [&](const Rational& v) -> R { return to_real<R>(h - abs(v)) * N(k * h + v); });
    };
    const R mean = (part(-h, 0) + part(0, h)) / to_real<R>(h * h), y = to_real<R>(k * h), length = to_real<R>(h);
    CHECK(size_of(R(kernel.mean_of_cells(y, length) - mean)) < 1000 * epsilon<R>());
    CHECK(kernel.mean_of_cells(-y, length) == kernel.mean_of_cells(y, length));
  }
}
