#include "model/exponent.hpp"

#include <doctest/doctest.h>

using namespace steadyslide;

TEST_CASE("Machin's formula is decided, and a near miss is not taken for it") {
  const Exponent quarter(Rational(1, 4));
  const auto a = [](int n, int d) { return Exponent::angle(Rational(n, d)); };
  CHECK(a(1, 5) + a(1, 5) + a(1, 5) + a(1, 5) - a(1, 239) == quarter);
  CHECK((a(1, 5) + a(1, 5) + a(1, 5) + a(1, 5) - a(1, 240) - quarter).sign() == 1);
}
