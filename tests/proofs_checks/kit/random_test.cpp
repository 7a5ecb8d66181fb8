#include "proofs_checks/kit/random.hpp"
#include "support/test.hpp"

using proofs_checks::Random;

namespace {

constexpr int draws = 20000;

/// Checks that the number found in so many draws with this chance is within five standard deviations.
void check_chance(int found, double chance) {
  CHECK_MESSAGE(std::abs(found - chance * draws) <= 5 * std::sqrt(draws * chance * (1 - chance)), found,
                " in place of ", chance * draws);
}

}  // namespace

TEST_CASE("random parameters stay in their ranges and depend on seed and stream alone") {
  Random one(7, "stream"), same(7, "stream"), other_seed(8, "stream"), other_stream(7, "another");
  int differs_by_seed = 0, differs_by_stream = 0;
  for (int k = 0; k < 500; ++k) {
    const auto draw = [](Random& r) { return std::array{r.poisson(), r.friction(50), r.between(-2, 3)}; };
    const auto drawn = draw(one);
    CHECK((drawn == draw(same)));
    differs_by_seed += drawn[0] != draw(other_seed)[0];
    differs_by_stream += drawn[0] != draw(other_stream)[0];
    const auto& [nu, f, between] = drawn;
    CHECK((nu > -1 && nu < 0.5_r));
    CHECK((f >= 0 && f < 50));
    CHECK((between > -2 && between < 3));
  }
  CHECK(differs_by_seed > 400);
  CHECK(differs_by_stream > 400);
}

TEST_CASE("one body in eight is nearly incompressible, one in eight nearly at the other end") {
  Random random(11, "poisson");
  const Rational near(1, 1000);
  // 6 of the 9972 fractions with one of the four denominators, drawn over the whole range, are also that close.
  const double by_chance = 6.0 / 8 / 4 * 6 / 9972;
  int incompressible = 0, other_end = 0;
  for (int k = 0; k < draws; ++k) {
    const Rational nu = random.poisson();
    incompressible += 0.5_r - nu < near ? 1 : 0;
    other_end += nu + 1 < near ? 1 : 0;
  }
  check_chance(incompressible, 1.0 / 8 + by_chance);
  check_chance(other_end, 1.0 / 8 + by_chance);
}

TEST_CASE("one friction in ten is zero, the others come from ranges of three sizes alike") {
  Random random(12, "friction");
  int zero = 0, small = 0, medium = 0;
  for (int k = 0; k < draws; ++k) {
    const Rational f = random.friction(50);
    zero += f == 0 ? 1 : 0;
    small += f > 0 && f < 1 ? 1 : 0;
    medium += f >= 1 && f < 5 ? 1 : 0;
  }
  check_chance(zero, 0.1);
  // 0 to 1, 0 to 5 and 0 to 50 have the chance 3/10 each. Multiples of 1/7, one of four kinds of fractions, change this
  // slightly.
  const double below_1[] = {1, (1.0 / 6 + 12.0 / 63 + 199.0 / 999 + 1994.0 / 9972) / 4,
                            (0.0 + 1.0 / 63 + 19.0 / 999 + 199.0 / 9972) / 4};
  const double below_5_of_50 = (0.0 + 6.0 / 63 + 99.0 / 999 + 997.0 / 9972) / 4;
  check_chance(small, 0.3 * (below_1[0] + below_1[1] + below_1[2]));
  check_chance(medium, 0.3 * (1 - below_1[1] + below_5_of_50 - below_1[2]));
}

TEST_CASE("every numerator of every denominator is drawn, and as often") {
  Random random(13, "between");
  std::map<Rational, int> count;
  for (int k = 0; k < draws; ++k) ++count[random.between(0, 1)];
  for (int p = 1; p < 7; ++p) check_chance(count[Rational(p, 7)], 1.0 / 4 / 6);
  int of_64 = 0;
  for (int p = 1; p < 64; ++p) of_64 += count[Rational(p, 64)];
  // 1000 is divisible by 8: 1/8, ..., 7/8 come from there as well.
  check_chance(of_64, 1.0 / 4 + 7.0 / 999 / 4);
}

TEST_CASE("below: each value as often") {
  Random random(14, "below");
  int count[10] = {};
  for (int k = 0; k < draws; ++k) ++count[random.below(10)];
  for (const int found : count) check_chance(found, 0.1);
}
