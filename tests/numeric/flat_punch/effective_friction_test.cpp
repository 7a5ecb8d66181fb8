// Compares the integral over the free surface with the load shares of the closed form, which integrates the traction.
// The two have only the data in common.

#include "numeric/flat_punch/flat_punch.hpp"

#include "numeric/solution/contact_solution.hpp"
#include "random_punch.hpp"
#include "support/numeric_test.hpp"

namespace {

template <Real R>
Estimate<R> by_integral(const ContactProblem& punch) {
  return EffectiveFriction<R>(FrictionLayout<R>::of(punch)).value();
}

/// The sum of s times the part of the load under it.
template <Real R>
Estimate<R> by_traction(const ContactProblem& punch) {
  return to_real<R>(punch.elasticity().gamma()) * closed_form<R>(punch).solution->resultants().effective_friction;
}

template <Real R>
R difference(const ContactProblem& punch) {
  const Estimate<R> s = by_integral<R>(punch);
  CHECK(s.error <= 400 * epsilon<R>() * s.value);
  return size_of(R(s.value - by_traction<R>(punch).value)) / (s.value == 0 ? R(1) : s.value);
}

ContactProblem two_coatings(const Rational& rear, const Rational& front) {
  return reduced({rear, front}, {0.2_r}, one_piece(-1, 1, {0}), 1);
}

}  // namespace

TEST_CASE("the integral and the traction agree: 40 digits of random layouts") {
  for (unsigned n = 0; n < 200; ++n) {
    CAPTURE(n);
    CHECK(difference<double>(random_punch(n)) < 1e-13);
    if (n < 9) CHECK(difference<Real50>(random_punch(n)) < Real50("1e-40"));
  }
}

TEST_CASE("slow: 40 digits of 200 random layouts with up to eight jumps" * doctest::skip()) {
  for (unsigned n = 0; n < 200; ++n) {
    CAPTURE(n);
    CHECK(difference<Real50>(random_punch(n)) < Real50("1e-40"));
  }
}

TEST_CASE("control: one strip's friction changed by 1e-30 shows at 40 digits") {
  const Real50 changed = by_traction<Real50>(two_coatings(0.0375_r, 0.1875_r + 1e-30_r)).value;
  CHECK(size_of(Real50(by_integral<Real50>(two_coatings(0.0375_r, 0.1875_r)).value - changed)) > Real50("1e-32"));
}

TEST_CASE("digits from outside this project, where two computations agreed on them") {
  const Real50 known("0.0968816732174371398542");
  CHECK(size_of(Real50(by_integral<Real50>(two_coatings(0.0375_r, 0.1875_r)).value - known)) < Real50("1e-22"));
}

TEST_CASE_TEMPLATE("one coating: s itself, however large or small", R, double, Real50) {
  for (const Rational& s : {0_r, 1e-9_r, 0.3_r, 1_r, 50_r, 1e9_r, -0.3_r, -50_r}) {
    CAPTURE(to_string(s));
    const EffectiveFriction<R> friction(FrictionLayout<R>({R(0.25), R(2), R(0.01)}, {s, s, s}));
    const Estimate<R> value = friction.value();
    CHECK(size_of(R(value.value - to_real<R>(s))) <= value.error);
    CHECK(size_of(friction.direction_difference().value) <= friction.direction_difference().error);
  }
}

TEST_CASE("100 digits: jumps next to both ends and friction up to 50") {
  const ContactProblem punch = reduced({50, 0.1_r, 7}, {-0.99999_r, 0.9999_r}, one_piece(-1, 1, {0}), 1);
  CHECK(difference<Real100>(punch) < Real100("1e-95"));
}

TEST_CASE("mirrored strips under the other sign of s: the same friction") {
  for (unsigned n = 0; n < 18; ++n) {
    const ContactProblem punch = random_punch(n);
    const double forth = by_integral<double>(punch).value;
    CHECK(close(forth, -by_integral<double>(punch.mirrored()).value, 200));
  }
}

TEST_CASE_TEMPLATE("the derivative is that of small changes of alpha, and convex", R, double, Real50) {
  // One strip of the second coating around y = 1/2 gets another alpha: the change is int w over the strip, times the
  // change of alpha.
  const auto value = [](const Rational& s) {
    return EffectiveFriction<R>(FrictionLayout<R>({R(0.7), R(0.75), R(0.1), R(0.45)}, {0.3_r, 0.8_r, s, 0.8_r}))
        .value()
        .value;
  };
  const Rational change = std::same_as<R, double> ? 1e-4_r : 1e-14_r;
  const R angles = to_real<R>(Exponent::angle(0.8_r + change) - Exponent::angle(0.8_r - change));
  const R quotient = (value(0.8_r + change) - value(0.8_r - change)) / angles;
  const EffectiveFriction<R> friction(FrictionLayout<R>({R(0.7), R(1.3)}, {0.3_r, 0.8_r}));
  const auto w = [&](const R& from_left) { return friction.derivative(from_left, 2 - from_left).value; };
  // Gauss' rule with three nodes on the strip: its error is far below the error of the difference quotient in double.
  using std::sqrt;
  const R node = R(0.05) * sqrt(R(0.6));
  const R integral = R(0.1) * (5 * w(R(1.5) - node) + 8 * w(R(1.5)) + 5 * w(R(1.5) + node)) / 18;
  CHECK(size_of(R(quotient / integral - 1)) < 1e-7);
  CHECK(size_of(R(quotient / w(R(1.6)) - 1)) > 1e-2);
  for (const double at : {0.1, 0.5, 0.7, 1.0, 1.9}) CHECK(w(R(at - 0.01)) + w(R(at + 0.01)) > 2 * w(R(at)));
}

TEST_CASE("the derivative in another unit of length is the same") {
  const EffectiveFriction<double> one(FrictionLayout<double>({0.5, 1.5}, {0.3_r, 0.8_r}));
  const EffectiveFriction<double> other(FrictionLayout<double>({3.5, 10.5}, {0.3_r, 0.8_r}));
  CHECK(close(one.derivative(0.5, 1.5).value, other.derivative(3.5, 10.5).value, 50));
}

TEST_CASE_TEMPLATE("direction: the difference of two values, and Catalan's constant where friction is small", R, double,
                   Real50) {
  for (const unsigned n : {1u, 3u, 5u}) {
    const ContactProblem punch = random_punch(n);
    const EffectiveFriction<R> friction(FrictionLayout<R>::of(punch));
    const R back = -by_integral<R>(punch.with_sliding(Sliding::minus_x)).value;
    const Estimate<R> difference = friction.direction_difference();
    CHECK(size_of(R(friction.value().value - back - difference.value)) <= 200 * epsilon<R>() * back);
  }
  const R catalan(0.915965594177219015);
  for (const auto& [gamma, ratio] : {std::pair(0.1_r, 0.999377), {0.01_r, 0.999994}}) {
    const FrictionLayout<R> halves({R(1), R(1)}, {0.1_r * gamma, 0.5_r * gamma});
    const R g = to_real<R>(gamma);
    const R difference = EffectiveFriction<R>(halves).direction_difference().value / g;
    const R first_order = -4 * catalan * g / (pi<R>() * pi<R>()) * R(0.25 - 0.01);
    CHECK(size_of(R(difference / first_order - R(ratio))) < 1e-6);
  }
}
