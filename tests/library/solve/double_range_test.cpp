// The range of double, and cases that need more digits.

#include "library/solve/double_range.hpp"
#include "support/test.hpp"

using namespace steadyslide::library;
using namespace steadyslide::numeric;

TEST_CASE_TEMPLATE("numbers of a size whose squares double has, and of a size that it has", R, double, Real50) {
  const auto power = [](int exponent) { return R(pow(R(10), exponent)); };
  for (const int sign : {1, -1}) {
    for (const int exponent : {0, 149, -149}) {
      CHECK(squares_in_double(R(sign * power(exponent))));
      CHECK(has_double(R(sign * power(exponent))));
    }
    for (const int exponent : {151, -151, 299, -299}) {
      CHECK_FALSE(squares_in_double(R(sign * power(exponent))));
      CHECK(has_double(R(sign * power(exponent))));
    }
    for (const int exponent : {301, -301}) CHECK_FALSE(has_double(R(sign * power(exponent))));
  }
  CHECK(squares_in_double(R(0)));
  CHECK_FALSE(squares_in_double(std::numeric_limits<R>::quiet_NaN()));
}

TEST_CASE("a number that is not known, or to three digits, asks for no more digits") {
  const double nan = std::nan("");
  CHECK(is_in_range(Estimate<double>{1, 0}));
  CHECK_FALSE(is_in_range(Estimate<double>{1e160, 1e150}));
  CHECK(is_in_range(Estimate<double>{1e160, 1e150}, has_double<double>));
  CHECK(is_in_range(Estimate<double>{1e160, 1e158}));
  CHECK(is_in_range(Estimate<double>{nan, infinity<double>()}));
  CHECK(is_in_range(Estimate<double>{infinity<double>(), 0}));
  CHECK_FALSE(is_in_range(Estimate<double>{nan, 0}));
}
