#include "symbolic/cln/cln_evaluation.hpp"
#include "model/singular_point.hpp"
#include "support/test.hpp"
#include "symbolic/cln/cln_number.hpp"

using namespace steadyslide::symbolic;

TEST_CASE("rounding to significant decimal digits") {
  // A number, the requested digits, the expected text.
  for (const std::string& row : words("0:5:0 1/3:5:0.33333 -2/3:5:-0.66667 0.5:1:0.5 25:1:3e1 24.999:1:2e1 "
                                      "9.9996:4:10.00 -999.96:4:-1000 99996:4:1.000e5 1234:3:1.23e3 0.0123:3:0.0123 "
                                      "0.00001:2:0.000010 0.000001:2:1.0e-6 1e-400:3:1.00e-400 -1e400:3:-1.00e400")) {
    CAPTURE(row);
    const std::size_t colon = row.find(':'), last = row.rfind(':');
    CHECK(rounded(parse_rational(row.substr(0, colon)), std::stoi(row.substr(colon + 1))).text == row.substr(last + 1));
  }
  CHECK_THROWS_AS(rounded(1, 0), std::domain_error);
  CHECK_THROWS_AS(cln_value(Exponent(1), 0), std::domain_error);
}

TEST_CASE("a rounded number says its value, and is off by half a unit at most") {
  CHECK(rc::check([] {
    const int digits = uniform(1, 29);
    const Rational value(*rc::gen::arbitrary<long long>(), 1 + uniform(0, 999999));
    const Decimal decimal = rounded(value, digits);
    RC_ASSERT(parse_rational(decimal.text) == decimal.value);
    const Rational scale(boost::multiprecision::pow(Integer(10), static_cast<unsigned>(digits)));
    RC_ASSERT(2 * abs(decimal.value - value) * scale <= 10 * abs(value));
  }));
}

TEST_CASE("exponents and angles against values from mpmath at 150 digits") {
  // atan(3/35)/pi
  CHECK(cln_value(Exponent::angle(Rational(3, 35)), 60).text ==
        "0.0272171802988209161101093976573085163974457587419772389416613");
  CHECK(cln_value(Exponent::angle(Rational(3, 35)), 120).text ==
        "0."
        "02721718029882091611010939765730851639744575874197723894166131688213047377677100632461361953355216444960789443"
        "12990174328");
  // 1/2 - atan(1e30)/pi: thirty digits cancel.
  CHECK(cln_value(free_exponent(End::left, 1e30_r), 60).text ==
        "3.18309886183790671537767526745028724068919291480912897495335e-31");
  CHECK(cln_value(Exponent(0.25_r), 5).text == "0.25000");
  CHECK(cln_value(Exponent(0.25_r) - Exponent::angle(1), 60).text == "0");
  CHECK(cln_value(Exponent::angle(0.5_r) + Exponent::angle(Rational(1, 3)) - Exponent(0.25_r), 60).text == "0");
  CHECK(cln_value(-free_exponent(End::left, 1e400_r), 30).text == "-3.18309886183790671537767526745e-401");
  CHECK(cln_value(Exponent::angle(1e-400_r), 30).text == "3.18309886183790671537767526745e-401");
}

TEST_CASE("gamma, alpha and cos(pi alpha)") {
  // gamma = 2/7 and 1/3.
  CHECK(cln_alpha(0.3_r, 0.3_r, Plane::strain, 60).text == cln_value(Exponent::angle(Rational(3, 35)), 60).text);
  CHECK(cln_alpha(Rational(1, 3), 3, Plane::stress, 60).text == cln_value(Exponent(0.25_r), 60).text);
  const auto cosine = [](const Rational& s, int digits) {
    return rounded(from_cln(cos_pi_alpha(s, cln_format(digits + cln_guard_digits))), digits).text;
  };
  CHECK(cosine(-0.75_r, 10) == "0.8000000000");
  CHECK(cosine(1_r, 60) == "0.707106781186547524400844362104849039284835937688474036588340");
  CHECK_THROWS_AS(cln_alpha(0.5_r, 1, Plane::strain, 10), std::domain_error);
  CHECK_THROWS_AS(cln_alpha(-1, 1, Plane::stress, 10), std::domain_error);
}

TEST_CASE("the formulas as printed agree with the model's, which go through Kolosov's constant") {
  CHECK(rc::check([] {
    const Rational nu(uniform(-999, 498), 1000);
    for (const Plane plane : {Plane::strain, Plane::stress}) {
      const Exponent alpha = Exponent::angle(Elasticity(Solid(nu, 1), plane).gamma());
      RC_ASSERT(cln_alpha(nu, 1, plane, 120).text == cln_value(alpha, 120).text);
    }
  }));
}

TEST_CASE("an exponent is the same however its terms are grouped") {
  CHECK(rc::check([] {
    const auto slope = [] { return Rational(uniform(-100000, 99999), uniform(1, 999)); };
    Exponent sum(Rational(uniform(-8, 7), 4));
    for (int terms = uniform(0, 5); terms > 0; --terms) sum += Exponent::angle(slope());
    const Exponent::Reduced reduced = sum.reduced();
    const Exponent again = Exponent(Rational(reduced.halves) / 2) + Exponent::angle(reduced.slope);
    RC_ASSERT(cln_value(sum, 60).text == cln_value(again, 60).text);
  }));
}
