// Sums of quotients by Chebyshev's moments beside the sums themselves.

#include "numeric/quadrature/distant_sum.hpp"

#include "support/numeric_test.hpp"

TEST_CASE_TEMPLATE("sums over far nodes by moments", R, Real50, Real100) {
  std::vector<R> y, f;
  for (int i = 0; i <= 40; ++i) {
    y.push_back(R(i * i) / 1600);
    f.push_back(R(1 + (7 * i) % 11) / (i % 3 == 0 ? -3 : 13));
  }
  const DistantSum<R> distant(y, f.data());
  for (const char* place : {"0.5", "0.51", "1", "3.7", "1e3", "1e40"}) {
    CAPTURE(place);
    const R x = to_real<R>(parse_rational(place));
    for (const bool beyond_one : {false, true}) {
      R sum = 0, size = 0;
      for (std::size_t i = 0; i < y.size(); ++i) {
        const R term = f[i] / (x + (beyond_one ? R(1 - y[i]) : y[i]));
        sum += term;
        size += size_of(term);
      }
      CHECK(size_of(R(distant.value(x, beyond_one) - sum)) <= 8 * epsilon<R>() * size);
      // Controls: the other end, and a place beside this one in the last digits but five.
      if (x < 100) CHECK(size_of(R(distant.value(x, !beyond_one) - sum)) > R(1e-6) * size);
      const R beside = x * (1 + 1e5 * epsilon<R>());
      CHECK(size_of(R(distant.value(beside, beyond_one) - sum)) > 8 * epsilon<R>() * size);
      CHECK(size <= distant.size() / x);
      CHECK(3 * size >= distant.size() / x);
    }
  }
}
