// Sums of quotients by moments and series, compared with the direct sums.

#include "numeric/quadrature/distant_sum.hpp"
#include "numeric/quadrature/graded_sum.hpp"
#include "numeric/quadrature/local_sum.hpp"
#include "support/numeric_test.hpp"

namespace {

/// The sum term by term.
template <Real R>
struct Sum {
  R value = 0, size = 0;

  void add(const R& term) {
    value += term;
    size += size_of(term);
  }
  bool is(const R& found) const { return size_of(R(found - value)) <= 8 * epsilon<R>() * size; }
};

}  // namespace

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
      Sum<R> sum;
      for (std::size_t i = 0; i < y.size(); ++i) sum.add(R(f[i] / (x + (beyond_one ? R(1 - y[i]) : y[i]))));
      CHECK(sum.is(distant.value(x, beyond_one)));
      // Controls: the other end, and a place that differs by the factor 1 + 1e5 epsilon.
      if (x < 100) CHECK(size_of(R(distant.value(x, !beyond_one) - sum.value)) > R(1e-6) * sum.size);
      const R beside = x * (1 + 1e5 * epsilon<R>());
      CHECK_FALSE(sum.is(distant.value(beside, beyond_one)));
      CHECK(sum.size <= distant.size() / x);
      CHECK(3 * sum.size >= distant.size() / x);
    }
  }
}

TEST_CASE_TEMPLATE("sums over sources on hundreds of scales", R, Real50, Real100) {
  using Panel = typename GradedSum<R>::Panel;
  constexpr std::size_t octaves = 200;
  std::vector<Panel> panels{{R(0), R(ldexp(R(1), -static_cast<int>(octaves))), {}, {}}};
  for (std::size_t k = 0; k < octaves; ++k) panels.push_back({panels.back().end, 2 * panels.back().end, {}, {}});
  for (std::size_t k = 0; k < panels.size(); ++k) {
    Panel& panel = panels[k];
    for (int i = 1; i <= 5; ++i) {
      panel.y.push_back(panel.begin + (panel.end - panel.begin) * i / 6);
      panel.f.push_back((panel.end - panel.begin) * ((7 * i + 3 * static_cast<int>(k)) % 11 - 4));
    }
  }
  GradedSum<R> graded(panels);
  // Errors as large as the sources double the sum of absolute values.
  std::vector<Panel> rough = panels;
  for (Panel& panel : rough) {
    for (const R& f : panel.f) panel.rounding.push_back(std::abs(static_cast<double>(f)));
  }
  GradedSum<R> with_errors(std::move(rough));
  const auto near_sum = [&panels](const R& x, std::size_t first, std::size_t end) {
    Sum<R> sum;
    for (std::size_t k = first; k < end; ++k) {
      for (std::size_t i = 0; i < panels[k].y.size(); ++i) sum.add(R(panels[k].f[i] / (x + panels[k].y[i])));
    }
    return sum;
  };
  for (const char* place : {"1", "0", "1e-70", "3e-50", "1e-30", "0.01", "0.3", "20"}) {
    CAPTURE(place);
    const R x = to_real<R>(parse_rational(place));
    const Sum<R> sum = near_sum(x, 0, panels.size());
    const auto far = graded.at(x);
    CHECK(far.end - far.first <= 8);
    const Sum<R> near = near_sum(x, far.first, far.end);
    CHECK(sum.is(far.value + near.value));
    CHECK(near.size + far.size >= (1 - 1e-6) * sum.size);
    CHECK(near.size + far.size <= R(1.2) * sum.size);
    CHECK(with_errors.at(x).size == doctest::Approx(2 * far.size));
    // Controls: one panel is missing, or the place differs.
    if (far.end > far.first + 1) CHECK_FALSE(sum.is(far.value + near_sum(x, far.first + 1, far.end).value));
    if (x > 0) CHECK_FALSE(sum.is(graded.at(x * (1 + R(1e-20))).value + near.value));
  }
}

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
    Sum<R> direct;
    for (const auto& [f, distance, is_right] : sources) {
      direct.add(is_right ? R(f / (distance + 1 - y)) : R(-f / (distance + y)));
    }
    CAPTURE(static_cast<double>(y));
    const Sum<R> by_sizes{direct.value, R(sum.size())};
    CHECK(by_sizes.is(sum.value(y)));
    CHECK(direct.size <= by_sizes.size);
    CHECK(3 * direct.size >= by_sizes.size);
    // Controls: the mirrored place, and one that differs by 1e5 epsilon.
    if (y != R(0.5)) CHECK(size_of(R(sum.value(R(1 - y)) - direct.value)) > R(1e-6) * direct.size);
    CHECK_FALSE(direct.is(sum.value(R(y + 1e5 * epsilon<R>()))));
  }
}
