#include "numeric/flat_punch/flat_punch.hpp"

#include "support/numeric_test.hpp"

namespace {

double s_eff(const std::vector<Rational>& s, int periods) {
  const auto layout = FrictionLayout<double>::periodic({0.5_r, 0.5_r}, s, periods);
  return EffectiveFriction<double>(layout).value().value;
}

}  // namespace

TEST_CASE("s = 0 | 2: slow, from both sides") {
  const auto fine = fine_mixture<double>({0.5_r, 0.5_r}, {0_r, 2_r});
  CHECK(std::abs(fine.s_eff.value - (std::sqrt(5.0) - 1) / 2) < 1e-14);  // tan(arctan(2)/2)
  CHECK(std::abs(s_eff({0_r, 2_r}, 64) - 0.547) < 5e-4);
  CHECK(std::abs(s_eff({2_r, 0_r}, 64) - 0.838) < 5e-4);
}

TEST_CASE("the order 1/2 - <alpha> is that of 1,024 periods whichever coating is outermost") {
  for (const auto& [a, b] : {std::pair(0_r, 2_r), {0_r, 0.5_r}, {0.1_r, 10_r}, {1_r, 3_r}}) {
    for (const auto& s : {std::vector{a, b}, std::vector{b, a}}) {
      CAPTURE(to_string(s[0]));
      CAPTURE(to_string(s[1]));
      const auto [limit, order] = fine_mixture<double>({0.5_r, 0.5_r}, s);
      double e[3];
      for (int k = 0; k < 3; ++k) e[k] = s_eff(s, 256 << k) - limit.value;
      CHECK((e[2] > 0) == (s[0] > s[1]));
      const double measured = order_of_periods(e[0], e[1], e[2]);
      CHECK(std::abs(measured - order) < 0.001);
      CHECK(std::abs(measured - 0.5) > 0.02);  // control: the order without friction
      // For large friction, the quotient of two neighbours already is near the order.
      if (b >= 2) CHECK(std::abs(std::log2(e[1] / e[2]) - order) < 0.02);
    }
  }
}

TEST_CASE_TEMPLATE("the limit is at most the mean of s, and the same from large friction", R, double, Real50) {
  for (const auto& [a, b] : {std::pair(0_r, 2_r), {1e-6_r, 0.5_r}, {10_r, 1e6_r}, {1e8_r, 1e9_r}}) {
    const auto fine = fine_mixture<R>({0.25_r, 0.75_r}, {a, b});
    CHECK(fine.s_eff.value < to_real<R>((a + 3 * b) / 4));
    CHECK(fine.s_eff.value > to_real<R>(a));
    CHECK(close(R(-fine.s_eff.value), fine_mixture<R>({0.25_r, 0.75_r}, {-a, -b}).s_eff.value, 1));
  }
  // cot(pi (1/2 - alpha)) = s for one coating.
  CHECK(close(fine_mixture<R>({1_r}, {1e9_r}).s_eff.value, R(1e9), 16));
}
