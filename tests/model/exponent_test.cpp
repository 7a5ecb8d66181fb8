#include <mpfr.h>
#include <cstdlib>

#include "broken_rule.hpp"
#include "model/exponent.hpp"

namespace {

/// The sign of the exponent, by summing its terms with so many bits that a sum below 2^(-bits/2) can only be zero: all
/// nonzero sums of these tests are larger.
int sign_by_summation(const Exponent& exponent, mpfr_prec_t bits = 4096) {
  mpfr_t sum, term, pi;
  mpfr_inits2(bits, sum, term, pi, static_cast<mpfr_ptr>(nullptr));
  mpfr_const_pi(pi, MPFR_RNDN);
  mpfr_set_q(sum, exponent.offset().backend().data(), MPFR_RNDN);
  mpfr_mul(sum, sum, pi, MPFR_RNDN);
  for (const Exponent::Angle& angle : exponent.angles()) {
    mpfr_set_q(term, angle.slope.backend().data(), MPFR_RNDN);
    mpfr_atan(term, term, MPFR_RNDN);
    mpfr_mul_si(term, term, angle.times, MPFR_RNDN);
    mpfr_add(sum, sum, term, MPFR_RNDN);
  }
  const bool zero = mpfr_zero_p(sum) != 0 || mpfr_get_exp(sum) < -bits / 2;
  const int sign = zero ? 0 : mpfr_sgn(sum);
  mpfr_clears(sum, term, pi, static_cast<mpfr_ptr>(nullptr));
  return (sign > 0) - (sign < 0);
}

/// Small fractions, often equal or related, sometimes a very large or very small one.
Rational random_slope() {
  const Rational slope(uniform(-12, 12), uniform(1, 8));
  const int kind = uniform(0, 9);
  return kind == 0 ? slope * 1e100_r : kind == 1 ? slope * 1e-100_r : slope;
}

Exponent random_exponent(int most_terms) {
  Exponent sum(Rational(uniform(-8, 8), 4));
  for (int terms = uniform(0, most_terms); terms > 0; --terms) sum += Exponent::angle(random_slope());
  return sum;
}

/// An exponent of 200 terms.
Exponent long_exponent() {
  Exponent sum(Rational(uniform(-200, 199), 4));
  for (int k = 0; k < 200; ++k) sum += Exponent::angle(Rational(uniform(-2000, 2000), uniform(1, 999)));
  return sum;
}

/// Returns arctan(a) + arctan(b) as one angle and a multiple of pi.
Exponent merged(const Rational& a, const Rational& b) {
  const Rational below = 1 - a * b;
  if (below == 0) return Exponent(a > 0 ? 0.5_r : -0.5_r);
  return Exponent::angle((a + b) / below) + Exponent(below > 0 ? 0 : a > 0 ? 1 : -1);
}

/// A sum of angles that is zero, although no two terms cancel: arctan a_1 + ... + arctan a_n minus the same merged pair
/// by pair.
Exponent hidden_zero(int terms) {
  Exponent sum;
  Rational merged_slope = uniform(-5, 5);
  sum += Exponent::angle(merged_slope);
  Exponent turns;
  for (; terms > 0; --terms) {
    const Rational next(uniform(-30, 30), uniform(1, 19)), below = 1 - merged_slope * next;
    if (below == 0) continue;
    sum += Exponent::angle(next);
    turns += Exponent(below > 0 ? 0 : merged_slope > 0 ? 1 : -1);
    merged_slope = (merged_slope + next) / below;
  }
  return sum - turns - Exponent::angle(merged_slope);
}

}  // namespace

TEST_CASE("Machin's formula is decided, and a near miss is not taken for it") {
  const Exponent quarter(0.25_r);
  const auto a = [](int n, int d) { return Exponent::angle(Rational(n, d)); };
  const Exponent four = a(1, 5) + a(1, 5) + a(1, 5) + a(1, 5);
  CHECK(four - a(1, 239) == quarter);
  CHECK((four - a(1, 240) - quarter).sign() == 1);
  CHECK((four - a(1, 238) - quarter).sign() == -1);
  CHECK(a(1, 1) + a(2, 1) + a(3, 1) == Exponent(1));
  CHECK(a(1, 2) + a(1, 3) == quarter);
  CHECK(a(3, 4) + a(4, 3) == Exponent(0.5_r));
}

TEST_CASE("the sign agrees with a summation at 4096 bits") {
  int signs[3] = {0, 0, 0};
  CHECK(rc::check([&] {
    const bool is_long = uniform(0, 3) == 0;
    const Exponent e = is_long ? long_exponent() : random_exponent(8);
    const int sign = e.sign();
    ++signs[sign + 1];
    RC_ASSERT(sign == sign_by_summation(e, is_long ? 1024 : 4096));
    RC_ASSERT((-e).sign() == -sign);
  }));
  CHECK(signs[0] > 10);
  CHECK(signs[2] > 10);
}

TEST_CASE("arctan a + arctan b = arctan((a+b)/(1-ab)), with the branch") {
  CHECK(rc::check([] {
    const Rational a = random_slope(), b = random_slope();
    RC_ASSERT(Exponent::angle(a) + Exponent::angle(b) == merged(a, b));
    // The wrong branch.
    RC_ASSERT(!(Exponent::angle(a) + Exponent::angle(b) == merged(a, b) + Exponent(1)));
    if (a > 0) RC_ASSERT(Exponent::angle(a) + Exponent::angle(1 / a) == Exponent(0.5_r));
  }));
}

TEST_CASE("hidden zeros are found, and a zero moved by 1e-200 is none") {
  const Rational tiny = 1e-200_r;
  int long_ones = 0;
  CHECK(rc::check([&] {
    const Exponent zero = hidden_zero(uniform(1, 11));
    long_ones += zero.angles().size() > 5;
    RC_ASSERT(zero.sign() == 0);
    RC_ASSERT(zero == Exponent());
    RC_ASSERT(zero.reduced() == Exponent().reduced());
    const Exponent above = zero + Exponent::angle(tiny), below = zero - Exponent::angle(tiny);
    RC_ASSERT(above.sign() == 1);
    RC_ASSERT(below.sign() == -1);
    RC_ASSERT(!(above == zero));
    RC_ASSERT(above.reduced().slope == tiny);
    RC_ASSERT(sign_by_summation(zero) == 0);
    RC_ASSERT(sign_by_summation(above) == 1);
    // One slope is changed by the factor 1 + 1e-200.
    if (!zero.angles().empty()) {
      const Rational slope = zero.angles()[0].slope;
      const Exponent moved = zero - Exponent::angle(slope) + Exponent::angle(slope * (1 + tiny));
      RC_ASSERT(moved.sign() == 1);
    }
  }));
  CHECK(long_ones > 20);
}

TEST_CASE("the reduced form is in its range, is the same number, and is unique") {
  CHECK(rc::check([] {
    const bool is_long = uniform(0, 3) == 0;
    const Exponent e = is_long ? long_exponent() : random_exponent(8);
    const Exponent::Reduced reduced = e.reduced();
    RC_ASSERT(reduced.slope > -1);
    RC_ASSERT(reduced.slope <= 1);
    const Exponent again = Exponent(Rational(reduced.halves) / 2) + Exponent::angle(reduced.slope);
    RC_ASSERT(again == e);
    RC_ASSERT(again.reduced() == reduced);
    if (!is_long) RC_ASSERT(sign_by_summation(again - e) == 0);
    // For any two exponents: the reduced forms are equal if and only if the difference is 0.
    const Exponent other = random_exponent(2);
    if (!is_long) RC_ASSERT((other.reduced() == reduced) == (sign_by_summation(other - e) == 0));
  }));
}

TEST_CASE("the corners of the reduced form") {
  const auto is = [](const Exponent& exponent, int halves, const Rational& slope) {
    return exponent.reduced() == Exponent::Reduced{halves, slope};
  };
  CHECK(is(Exponent(), 0, 0));
  CHECK(is(Exponent(0.25_r), 0, 1));
  CHECK(is(Exponent(-0.25_r), -1, 1));
  CHECK(is(Exponent(0.75_r), 1, 1));
  CHECK(is(Exponent(-0.75_r), -2, 1));
  CHECK(is(Exponent::angle(1), 0, 1));
  CHECK(is(Exponent::angle(-1), -1, 1));
  CHECK(is(Exponent::angle(2), 1, -0.5_r));
  CHECK(is(-half - Exponent::angle(2), -2, 0.5_r));
  CHECK(is(Exponent(1000000), 2000000, 0));
}

TEST_CASE("huge and tiny slopes") {
  const Rational huge = 1e400_r * 1e400_r;
  CHECK((half - Exponent::angle(huge)).sign() == 1);
  CHECK((half + Exponent::angle(-huge)).sign() == 1);
  CHECK((Exponent::angle(huge + 1) - Exponent::angle(huge)).sign() == 1);
  CHECK((Exponent::angle(1 / huge) - Exponent::angle(1 / (huge + 1))).sign() == 1);
  CHECK((half - Exponent::angle(huge)) == Exponent::angle(1 / huge));
  CHECK((half - Exponent::angle(huge)).reduced() == Exponent::Reduced{0, 1 / huge});
}

TEST_CASE("exponents add like numbers, in any order") {
  CHECK(rc::check([] {
    const Exponent a = random_exponent(4), b = random_exponent(4), c = random_exponent(4);
    RC_ASSERT(a + b == b + a);
    RC_ASSERT((a + b) + c == a + (b + c));
    RC_ASSERT((a - b) + b == a);
    RC_ASSERT(a - b == -(b - a));
    RC_ASSERT(-(-a) == a);
    RC_ASSERT((a - a).sign() == 0);
    Exponent twice = a;
    twice += twice;
    RC_ASSERT(twice == a + a);
    Exponent none = a;
    none -= none;
    RC_ASSERT(none == Exponent());
    const Exponent sum = a + b;
    for (const Exponent::Angle& angle : sum.angles()) {
      RC_ASSERT(angle.times != 0);
      RC_ASSERT(angle.slope > 0);
    }
  }));
}

TEST_CASE("an angle is counted so many times and no more") {
  Exponent sum = Exponent::angle(0.5_r);
  const auto twice = [&] { sum += sum; };
  for (int k = 0; k < 13; ++k) twice();
  CHECK(sum.angles()[0].times == 8192);
  CHECK(sum.sign() == 1);
  const std::string rule = ": angle counted too often; an exponent contains an angle at most 10000 times; ";
  CHECK(refusal(twice) == rule + "16384");
  CHECK(refusal([&] { sum += Exponent(sum); }) == rule + "16384");
  CHECK(refusal([&] { sum -= -sum; }) == rule + "16384");
  CHECK((sum - sum).angles().empty());
}

TEST_CASE("exponents as text, and an offset that is none") {
  CHECK(to_string(Exponent()) == "0");
  CHECK(to_string(Exponent(-0.5_r) - Exponent::angle(Rational(3, 35))) == "-1/2 - arctan(3/35)/pi");
  CHECK(to_string(Exponent::angle(-2)) == "-arctan(2)/pi");
  CHECK(to_string(Exponent::angle(2) + Exponent::angle(2) - Exponent(1)) == "-1 + 2*arctan(2)/pi");
  CHECK(to_string(Exponent::angle(2) - Exponent::angle(Rational(1, 3))) == "arctan(2)/pi - arctan(1/3)/pi");
  CHECK(refusal([] { Exponent(Rational(1, 3)); }) ==
        ": offset of an exponent out of range; the offset is a multiple of 1/4; 1/3");
  CHECK(refusal([] { Exponent(-1.75_r); }) == "accepted");
}
