#include "numeric/number/real.hpp"
#include "numeric/number/power.hpp"
#include "support/numeric_test.hpp"

TEST_CASE("rationals become the nearest double, not the truncated one") {
  CHECK(to_real<double>(Rational(2, 3)) == 2.0 / 3);
  CHECK(to_real<double>(Rational(-1, 10)) == -0.1);
  CHECK(to_real<double>(parse_rational("0.7")) == 0.7);
  CHECK(to_real<Real100>(Rational(1, 3)) * 3 == 1);
}

TEST_CASE("1 + lambda keeps all digits where lambda is next to -1") {
  // At an edge with s = 1e30, lambda = -(1/2 + alpha) rounds to -1, but 1 + lambda = arctan(1e-30)/pi.
  const Exponent edge = Exponent(Rational(-1, 2)) - Exponent::angle(parse_rational("1e30"));
  const Power<double> power = Power<double>::of(edge);
  CHECK(power.value == -1.0);
  CHECK(power.plus_one == doctest::Approx(1e-30 / pi<double>()).epsilon(1e-14));
  CHECK(1 + power.value == 0);  // the result of forming it from lambda
}

TEST_CASE("a difference of two close angles does not cancel") {
  const Rational s = parse_rational("3.7"), tiny = parse_rational("1e-40");
  const Exponent beta = Exponent::angle(s + tiny) - Exponent::angle(s);
  const double expected = 1e-40 / (1 + 3.7 * 3.7) / pi<double>();
  CHECK(to_real<double>(beta) == doctest::Approx(expected).epsilon(1e-14));
}

TEST_CASE("one door from run time to type") {
  const auto bits = [](int digits) {
    return at_precision(precision_for(digits), []<class R>() { return std::numeric_limits<R>::digits; });
  };
  CHECK(bits(1) == 53);
  CHECK(bits(16) == 53);
  CHECK(bits(17) == 191);
  CHECK(bits(50) == 191);
  CHECK(bits(51) == 380);
  CHECK(bits(100) == 380);
  CHECK_THROWS_AS(precision_for(0), std::out_of_range);
  CHECK_THROWS_AS(precision_for(101), std::out_of_range);
}

TEST_CASE("pi to 100 digits, from Machin's formula in rationals") {
  // pi = 16 arctan(1/5) - 4 arctan(1/239), alternating series cut below 1e-120.
  const auto arctan_inverse = [](int n) {
    Rational sum = 0, power(1, n);
    for (int k = 0; k < 180; ++k, power /= n * n) sum += (k % 2 == 0 ? power : Rational(-power)) / (2 * k + 1);
    return sum;
  };
  const Rational machin = 16 * arctan_inverse(5) - 4 * arctan_inverse(239);
  CHECK(abs(to_real<Real100>(machin) - pi<Real100>()) < 4 * epsilon<Real100>());
  CHECK(to_real<double>(machin) == pi<double>());
}
