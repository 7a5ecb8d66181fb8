// Series for many places beside the sums over the sources themselves.

#include "numeric/quadrature/local_sum.hpp"

#include "support/numeric_test.hpp"

TEST_CASE_TEMPLATE("sums over far sources as one series", R, Real50, Real100) {
  struct Source {
    R f, distance;
    bool is_right;
  };
  std::vector<Source> sources;
  LocalSum<R> sum;
  for (int i = 0; i <= 60; ++i) {
    using std::pow;
    const R distance = i == 0 ? R(0.5) : R(0.5) + pow(R(10), R(i % 7)) * i / 60;
    sources.push_back({R(1 + (7 * i) % 11) / (i % 3 == 0 ? -3 : 13), distance, i % 2 == 0});
    sum.add(sources.back().f, distance, sources.back().is_right);
  }
  for (const R& y : {R(0), R(0.001), R(0.3), R(0.5), R(0.77), R(1)}) {
    R direct = 0, size = 0;
    for (const auto& [f, distance, is_right] : sources) {
      const R term = is_right ? R(f / (distance + 1 - y)) : R(-f / (distance + y));
      direct += term;
      size += size_of(term);
    }
    CAPTURE(static_cast<double>(y));
    CHECK(size_of(R(sum.value(y) - direct)) <= 8 * epsilon<R>() * R(sum.size()));
    CHECK(size <= R(sum.size()));
    CHECK(3 * size >= R(sum.size()));
    // Controls: the mirrored place, and one beside it in the last digits but five.
    if (y != R(0.5)) CHECK(size_of(R(sum.value(R(1 - y)) - direct)) > R(1e-6) * size);
    CHECK(size_of(R(sum.value(R(y + 1e5 * epsilon<R>())) - direct)) > 8 * epsilon<R>() * size);
  }
}
