#include "numeric/number/elementary.hpp"

#include "support/numeric_test.hpp"

namespace {

/// The value as MPFR rounds it correctly.
template <class R>
R by_mpfr(int (*f)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t), const R& x) {
  R result;
  f(result.backend().data(), x.backend().data(), MPFR_RNDN);
  return result;
}

template <class R>
R power_by_mpfr(const R& base, const R& exponent) {
  R result;
  mpfr_pow(result.backend().data(), base.backend().data(), exponent.backend().data(), MPFR_RNDN);
  return result;
}

/// Equal, or neighbours: a ball with 16 more bits may contain the middle between two numbers.
template <class R>
bool same_to_the_last_bit(const R& a, const R& b) {
  R above = b, below = b;
  mpfr_nextabove(above.backend().data());
  mpfr_nextbelow(below.backend().data());
  return a == b || a == above || a == below;
}

/// A positive number with random bits and the binary exponent `exponent`.
template <class R>
R with_exponent(long exponent) {
  R x = 0;
  for (int i = 0; i < 13; ++i) x = (x + uniform(0, (1 << 30) - 1)) / (1 << 30);
  return ldexp(R(x / 2 + R(0.5)), exponent);
}

/// Some numbers are tiny, some huge, some next to 1.
template <class R>
R positive() {
  switch (uniform(0, 4)) {
    case 0: return with_exponent<R>(uniform(-1'000'000, 1'000'000));
    case 1: return 1 + with_exponent<R>(-uniform(1, std::numeric_limits<R>::digits - 1));
    case 2: return 1 - with_exponent<R>(-uniform(1, std::numeric_limits<R>::digits));
    default: return with_exponent<R>(uniform(-4, 4));
  }
}

}  // namespace

TEST_CASE_TEMPLATE("log, exp and pow are MPFR's to the last bit, of any size and next to 1", R, Real50, Real100) {
  int differ = 0, all = 0;
  REQUIRE(rc::check([&] {
    const R x = positive<R>();
    const R y = (uniform(0, 1) == 0 ? 1 : -1) * with_exponent<R>(uniform(-400, 12));
    const std::pair<R, R> pairs[] = {
        {log(x), by_mpfr<R>(mpfr_log, x)}, {exp(y), by_mpfr<R>(mpfr_exp, y)}, {pow(x, y), power_by_mpfr<R>(x, y)}};
    for (const auto& [ours, correct] : pairs) {
      RC_ASSERT(same_to_the_last_bit(ours, correct));
      ++all;
      if (ours != correct) ++differ;
    }
  }));
  CHECK(differ <= all / 100);
}

TEST_CASE("control: a result two units of the last place off is seen") {
  const Real50 x = log(Real50(3));
  CHECK(same_to_the_last_bit<Real50>(x, by_mpfr<Real50>(mpfr_log, Real50(3))));
  CHECK_FALSE(same_to_the_last_bit<Real50>(x * (1 + 2 * epsilon<Real50>()), x));
}

TEST_CASE_TEMPLATE("what is no plain number is MPFR's", R, Real50, Real100) {
  const R inf = infinity<R>();
  CHECK(log(R(0)) == -inf);
  CHECK(log(inf) == inf);
  CHECK(log(R(1)) == 0);
  CHECK(isnan(log(R(-1))));
  CHECK(exp(R(0)) == 1);
  CHECK(exp(inf) == inf);
  CHECK(exp(R(-inf)) == 0);
  CHECK(exp(ldexp(R(1), 63)) == inf);
  CHECK(exp(ldexp(R(-1), 63)) == 0);
  CHECK(pow(R(0), R(0.5)) == 0);
  CHECK(pow(R(0), R(-0.5)) == inf);
  CHECK(pow(R(-2), R(3)) == -8);
  CHECK(isnan(pow(R(-2), R(0.5))));
  CHECK(pow(R(7), R(0)) == 1);
  // Up to the end of MPFR's range and beyond it; there both are infinite or zero.
  for (const int size : {20, 27, 28, 29, 30, 31, 40}) {
    for (const int sign : {1, -1}) {
      const R large = sign * (ldexp(R(3) / 4, size) + R(0.5));
      CHECK((pow(R(1.5), large) == power_by_mpfr<R>(R(1.5), large) ||
             same_to_the_last_bit<R>(pow(R(1.5), large), power_by_mpfr<R>(R(1.5), large))));
      CHECK((exp(large) == by_mpfr<R>(mpfr_exp, large) ||
             same_to_the_last_bit<R>(exp(large), by_mpfr<R>(mpfr_exp, large))));
    }
  }
}

TEST_CASE_TEMPLATE("a product of powers in one ball is that of MPFR's powers, also where a base is zero", R, Real50,
                   Real100) {
  const auto product = [](const std::vector<std::pair<R, R>>& powers, mpfr_prec_t bits) {
    elementary::PowerProduct balls(bits);
    balls.multiply(R(2).backend().data(), R(7).backend().data());
    balls.set_one();
    for (const auto& [x, y] : powers) balls.multiply(x.backend().data(), y.backend().data());
    R result;
    balls.value(result.backend().data());
    return result;
  };
  constexpr int all = std::numeric_limits<R>::digits;
  REQUIRE(rc::check([&] {
    std::vector<std::pair<R, R>> powers;
    R by_powers = 1, size = 1;
    for (int count = uniform(0, 6); count > 0; --count) {
      const auto& [x, y] =
          powers.emplace_back(positive<R>(), with_exponent<R>(uniform(-40, 1)) * (2 * uniform(0, 1) - 1));
      by_powers *= power_by_mpfr<R>(x, y);
      size += abs(y * by_mpfr<R>(mpfr_log, x));
    }
    for (const int bits : {all, all - 14}) {
      const auto factors = static_cast<double>(powers.size());
      RC_ASSERT(abs(product(powers, bits) / by_powers - 1) <= (2 * factors + 4) * size * ldexp(R(1), -bits));
    }
  }));
  const R half(0.5), zero(0), inf = std::numeric_limits<R>::infinity();
  CHECK(product({}, all) == 1);
  CHECK(product({{zero, half}, {R(3), half}}, all) == 0);
  CHECK(product({{zero, -half}, {R(3), half}}, all) == inf);
  CHECK(product({{ldexp(R(1), 1'000'000), ldexp(R(1), 20)}}, all) == inf);
  CHECK(product({{ldexp(R(1), 1'000'000), ldexp(R(-1), 20)}}, all) == 0);
}
