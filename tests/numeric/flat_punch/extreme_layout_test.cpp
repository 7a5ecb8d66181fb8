#include "numeric/flat_punch/flat_punch.hpp"

#include <numeric>
#include <random>

#include "support/numeric_test.hpp"

namespace {

const Rational smooth = 0.0375_r;
const Rational rough = 0.1875_r;

template <Real R>
R s_eff(const std::vector<R>& lengths, const std::vector<Rational>& s) {
  return EffectiveFriction<R>(FrictionLayout<R>(lengths, s)).value().value;
}

/// The friction of two alternating coatings, in up to ten strips of random lengths; `second_share` is the share of the
/// second one.
double random_friction(std::mt19937_64& engine, const Rational& first, const Rational& second, double second_share) {
  const std::size_t strips = 2 + engine() % 9;
  std::vector<double> lengths;
  std::vector<Rational> s;
  double sum[2] = {0, 0};
  for (std::size_t k = 0; k < strips; ++k) {
    const double u = static_cast<double>(engine() >> 11) * 0x1p-53;
    lengths.push_back(u * u * u + 1e-9);  // some are short
    s.push_back(k % 2 == 0 ? first : second);
    sum[k % 2] += lengths.back();
  }
  for (std::size_t k = 0; k < strips; ++k) lengths[k] *= (k % 2 == 0 ? 1 - second_share : second_share) / sum[k % 2];
  return s_eff<double>(lengths, s);
}

}  // namespace

TEST_CASE_TEMPLATE("two coatings, half and half: friction 0.231489 to 0.367149 at gamma = 3/8", R, double, Real50) {
  const auto largest = extreme_layout<R>(rough, smooth, 0.5_r);
  const auto smallest = extreme_layout<R>(smooth, rough, 0.5_r);
  // The first jump is at y = -1 + 2 left. The values are from outside this project.
  CHECK(size_of(R(2 * largest.left.value - 1 - R(-0.4232))) < 5e-5);
  CHECK(size_of(R(2 * smallest.left.value - 1 - R(-0.46))) < 5e-5);
  CHECK(size_of(R(largest.s_eff.value / R(0.375) - R(0.367149))) < 5e-7);
  CHECK(size_of(R(smallest.s_eff.value / R(0.375) - R(0.231489))) < 5e-7);
}

TEST_CASE("digits agree with more digits") {
  for (const auto& [outer, inner, share] :
       {std::tuple(rough, smooth, 0.5_r), {smooth, rough, 0.5_r}, {0_r, 50_r, 0.01_r}, {3_r, 50_r, 0.3_r}}) {
    const auto few = extreme_layout<double>(outer, inner, share);
    const auto more = extreme_layout<Real50>(outer, inner, share);
    CHECK(within_error(few.left, more.left));
    CHECK(within_error(few.right, more.right));
    CHECK(within_error(few.s_eff, more.s_eff));
    CHECK(few.left.error < 1e-9);
    CHECK(few.s_eff.error < 1e-13 * few.s_eff.value);
  }
}

TEST_CASE("slow: 100 digits of a layout continue 50" * doctest::skip()) {
  const auto more = extreme_layout<Real50>(rough, smooth, 0.5_r);
  const auto most = extreme_layout<Real100>(rough, smooth, 0.5_r);
  CHECK(size_of(Real100(Real100(more.left.value) - most.left.value)) <= Real100(more.left.error));
  CHECK(size_of(Real100(Real100(more.s_eff.value) - most.s_eff.value)) <= Real100(more.s_eff.error));
}

TEST_CASE("a stationary interval: moved either way it has less, or more") {
  for (const auto& [outer, inner] : {std::pair(rough, smooth), {smooth, rough}, {2_r, 0_r}, {0_r, 2_r}}) {
    const auto extreme = extreme_layout<double>(outer, inner, 0.3_r);
    const double sign = outer > inner ? 1 : -1;
    for (const double move : {-0.01, -0.001, 0.001, 0.01}) {
      const double moved =
          s_eff<double>({extreme.left.value + move, 0.3, extreme.right.value - move}, {outer, inner, outer});
      CHECK(sign * (extreme.s_eff.value - moved) > 0);
    }
  }
}

TEST_CASE("10,000 random layouts lie between the extremes; the extremes of another share do not hold them") {
  std::mt19937_64 engine(2016);
  for (const auto& [a, b, share] :
       {std::tuple(smooth, rough, 0.5_r), {0_r, 2_r, 0.3_r}, {0.5_r, 20_r, 0.6_r}, {1_r, 0.9_r, 0.1_r}}) {
    const auto [low, high] = std::minmax(a, b);
    const Rational low_share = a < b ? 1 - share : share;
    const double largest = extreme_layout<double>(high, low, low_share).s_eff.value;
    const double smallest = extreme_layout<double>(low, high, 1 - low_share).s_eff.value;
    const double wrong = extreme_layout<double>(high, low, low_share + 0.05_r).s_eff.value;
    CHECK(smallest < largest);
    int beyond = 0;
    int beyond_wrong = 0;
    for (int i = 0; i < 2500; ++i) {
      const double value = i % 2 == 0 ? random_friction(engine, a, b, static_cast<double>(share))
                                      : random_friction(engine, b, a, static_cast<double>(1 - share));
      if (value > largest * (1 + 1e-13) || value < smallest * (1 - 1e-13)) ++beyond;
      if (value > wrong) ++beyond_wrong;
    }
    CHECK(beyond == 0);
    CHECK(beyond_wrong > 0);
  }
}

TEST_CASE("sliding the other way: the same layout seen from behind") {
  const auto forth = extreme_layout<double>(rough, smooth, 0.4_r);
  const auto back = extreme_layout<double>(-rough, -smooth, 0.4_r);
  CHECK(close(forth.left.value, back.right.value, 1e5));
  CHECK(close(forth.s_eff.value, -back.s_eff.value, 200));
}

TEST_CASE("friction up to 1e9, and shares down to a millionth") {
  for (const auto& coatings : {std::pair(1e9_r, 0_r), {0_r, 1_r}, {5_r, 3_r}, {1e-9_r, 0_r}}) {
    const Rational &outer = coatings.first, &inner = coatings.second;
    for (const Rational& share : {1e-6_r, 0.5_r, 1 - 1e-6_r}) {
      CAPTURE(to_string(outer));
      CAPTURE(to_string(inner));
      CAPTURE(to_string(share));
      const auto extreme = extreme_layout<double>(outer, inner, share);
      CHECK(extreme.left.value > 0);
      CHECK(extreme.right.value > 0);
      CHECK(extreme.s_eff.value > to_real<double>(std::min(outer, inner)));
      CHECK(extreme.s_eff.value < to_real<double>(std::max(outer, inner)));
      const double moved = 0.1 * std::min(extreme.left.value, extreme.right.value);
      for (const double move : {-moved, moved}) {
        const double other = s_eff<double>(
            {extreme.left.value + move, to_real<double>(share), extreme.right.value - move}, {outer, inner, outer});
        CHECK((outer > inner ? 1 : -1) * (extreme.s_eff.value - other) > -extreme.s_eff.error);
      }
    }
  }
}

TEST_CASE("what is no pair of coatings is refused") {
  CHECK(thrown_by([] { extreme_layout<double>(1, 1, 0.5_r); }) == "two coatings of one friction");
  CHECK(thrown_by([] { extreme_layout<double>(1, 2, 1); }) == "a share is between 0 and 1");
  CHECK(thrown_by([] { extreme_layout<double>(0, 1e9_r, 1 - 1e-6_r); }) ==
        "a strip is shorter than 1e-200 of the contact");
  CHECK(thrown_by([] { FrictionLayout<double>({1.0, 0.0}, {1_r, 2_r}); }) == "a strip has a length > 0");
}
