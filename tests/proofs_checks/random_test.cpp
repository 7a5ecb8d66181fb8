#include "proofs_checks/kit/random.hpp"

#include <doctest/doctest.h>

using namespace steadyslide;
using proofs_checks::Random;

TEST_CASE("random parameters stay in their ranges and depend on seed and stream alone") {
  Random one(7, "stream");
  Random same(7, "stream");
  Random other_seed(8, "stream");
  Random other_stream(7, "another");
  int differs_by_seed = 0;
  int differs_by_stream = 0;
  for (int k = 0; k < 500; ++k) {
    const Rational nu = one.poisson();
    CHECK(nu == same.poisson());
    differs_by_seed += nu != other_seed.poisson();
    differs_by_stream += nu != other_stream.poisson();
    CHECK((nu > -1 && nu < Rational(1, 2)));
    const Rational f = one.friction(50);
    CHECK(f == same.friction(50));
    other_seed.friction(50);
    other_stream.friction(50);
    CHECK((f >= 0 && f < 50));
    const Rational between = one.between(-2, 3);
    CHECK(between == same.between(-2, 3));
    other_seed.between(-2, 3);
    other_stream.between(-2, 3);
    CHECK((between > -2 && between < 3));
  }
  CHECK(differs_by_seed > 400);
  CHECK(differs_by_stream > 400);
}
