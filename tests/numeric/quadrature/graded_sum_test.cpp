// Sums over sources on many scales, beside the sums themselves.

#include "numeric/quadrature/graded_sum.hpp"

#include "support/numeric_test.hpp"

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
  const auto near_sum = [&panels](const R& x, std::size_t first, std::size_t end) {
    std::pair<R, R> sum{0, 0};
    for (std::size_t k = first; k < end; ++k) {
      for (std::size_t i = 0; i < panels[k].y.size(); ++i) {
        const R term = panels[k].f[i] / (x + panels[k].y[i]);
        sum.first += term;
        sum.second += size_of(term);
      }
    }
    return sum;
  };
  for (const char* place : {"1", "0", "1e-70", "3e-50", "1e-30", "0.01", "0.3", "20"}) {
    CAPTURE(place);
    const R x = to_real<R>(parse_rational(place));
    const auto [value, size] = near_sum(x, 0, panels.size());
    const auto far = graded.at(x);
    CHECK(far.end - far.first <= 8);
    const auto [near, near_size] = near_sum(x, far.first, far.end);
    CHECK(size_of(R(far.value + near - value)) <= 8 * epsilon<R>() * size);
    CHECK(near_size + far.size >= (1 - 1e-6) * size);
    CHECK(near_size + far.size <= R(1.2) * size);
    // Controls: a panel is missing, or the place is another.
    if (far.end > far.first + 1) {
      CHECK(size_of(R(far.value + near_sum(x, far.first + 1, far.end).first - value)) > 8 * epsilon<R>() * size);
    }
    if (x > 0) {
      CHECK(size_of(R(graded.at(x * (1 + R(1e-20))).value + near - value)) > 8 * epsilon<R>() * size);
    }
  }
}
