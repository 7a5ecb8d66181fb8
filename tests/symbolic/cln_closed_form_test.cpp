#include "symbolic/cln/cln_closed_form.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <stdexcept>

#include "model/singular_point.hpp"
#include "symbolic/cln/cln_evaluation.hpp"
#include "uniform.hpp"

using namespace steadyslide;
using namespace steadyslide::symbolic;

namespace {

ContactProblem punch(const Rational& gamma, std::vector<Rational> f, std::vector<Rational> jumps,
                     const Rational& left = -1, const Rational& right = 1, Sliding sliding = Sliding::plus_x,
                     const Rational& load = 1) {
  return ContactProblem(Elasticity::reduced(gamma), FrictionProfile(std::move(f), std::move(jumps)),
                        Indenter(left, {{right, Polynomial()}}), load, sliding);
}

/// psi = (x - vertex)^2 / (2 radius), reduced data, friction s / gamma under gamma = 1/2.
ContactProblem parabola(std::vector<Rational> s, std::vector<Rational> jumps, const Rational& radius = Rational(1, 5),
                        const Rational& vertex = 0, const Rational& load = 1, const Rational& half_width = 10,
                        Sliding sliding = Sliding::plus_x) {
  for (Rational& value : s) value *= 2;
  const Polynomial from_vertex({-vertex, 1});
  return ContactProblem(
      Elasticity::reduced(Rational(1, 2)), FrictionProfile(std::move(s), std::move(jumps)),
      Indenter(-half_width, {{half_width, from_vertex * from_vertex * Polynomial({1 / (2 * radius)})}}), load, sliding);
}

// 1/pi, mpmath at 80 digits.
const Rational one_over_pi =
    parse_rational("0.31830988618379067153776752674502872406891929148091289749533468811779358");

bool near(const Decimal& a, const Rational& b, int digits) {
  const Integer scale = boost::multiprecision::pow(Integer(10), static_cast<unsigned>(digits));
  return abs(a.value - b) * scale <= abs(b) * 10;
}

}  // namespace

TEST_CASE("a parabola with a friction jump at its vertex: two independent computations at 40 digits") {
  // R = 0.2, P = 1, a jump at 0. The digits were made by two independent computations at 40 digits.
  const auto rising = ClnClosedForm::parabola(parabola({Rational(1, 10), Rational(6, 10)}, {0}), 40);
  REQUIRE(rising.size() == 1);
  CHECK(rising[0].left().text == "-0.4003017752023082835874813713471545627373");
  CHECK(rising[0].right().text == "0.2789364365421476101051427811594294453144");
  const auto falling = ClnClosedForm::parabola(parabola({Rational(6, 10), Rational(1, 10)}, {0}), 40);
  REQUIRE(falling.size() == 1);
  CHECK(falling[0].left().text == "-0.4900056280717151697542022236678901591541");
  CHECK(falling[0].right().text == "0.3022454527884637023227909724409309514227");
}

TEST_CASE("flat punch without jump: [Bal16, (4)], its powers taken apart by hand") {
  // gamma f = 1: alpha = 1/4 and t(x) = -(P/pi) cos(pi/4) (1+x)^(-3/4) (1-x)^(-1/4).
  const ClnClosedForm form = ClnClosedForm::flat_punch(punch(Rational(1, 2), {2}, {}), 60);
  CHECK(form.left().value == -1);
  CHECK(form.right().value == 1);
  CHECK(form.first_jump() == form.last_jump());
  // 1/(sqrt(2) pi), mpmath at 80 digits.
  CHECK(form.traction(0).text == "-0.225079079039276517388799797751685145666143537488805156392859");
  // (t(3/5)/t(0))^4 = (8/5)^-3 (2/5)^-1.
  const Rational ratio = form.traction(Rational(3, 5)).value / form.traction(0).value;
  CHECK(abs(ratio * ratio * ratio * ratio - Rational(625, 1024)) < parse_rational("1e-58"));
}

TEST_CASE("traction where it is not defined is refused, outside the contact it is zero") {
  const ClnClosedForm form = ClnClosedForm::flat_punch(
      punch(Rational(2, 7), {Rational(1, 5), Rational(3, 5), Rational(3, 5)}, {0, Rational(1, 2)}), 30);
  CHECK_THROWS_AS(form.traction(-1), std::domain_error);
  CHECK_THROWS_AS(form.traction(1), std::domain_error);
  CHECK_THROWS_AS(form.traction(0), std::domain_error);
  CHECK(form.traction(Rational(1, 2)).value < 0);  // a jump of height zero is no singular point
  CHECK(form.traction(2).text == "0");
  CHECK(form.traction(-2).text == "0");
  CHECK_THROWS_AS(ClnClosedForm::flat_punch(punch(Rational(2, 7), {1}, {}), 0), std::domain_error);
  CHECK_THROWS_AS(ClnClosedForm::flat_punch(parabola({0}, {}), 30), std::domain_error);
  CHECK_THROWS_AS(ClnClosedForm::parabola(punch(Rational(2, 7), {1}, {}), 30), std::domain_error);
}

TEST_CASE("more digits extend fewer digits") {
  const std::vector<Rational> f{Rational(1, 5), 3, Rational(1, 10), 50};
  const std::vector<Rational> jumps{Rational(-1, 4), Rational(1, 3), Rational(2, 3)};
  const auto problem = punch(Rational(2, 7), f, jumps);
  const auto curved = parabola(f, jumps);
  REQUIRE(ClnClosedForm::parabola(curved, 60).size() == 1);
  for (const Rational& x : {Rational(-9, 10), Rational(1, 10), parse_rational("0.333333"), parse_rational("-0.3")}) {
    CHECK(rounded(ClnClosedForm::flat_punch(problem, 120).traction(x).value, 60).text ==
          ClnClosedForm::flat_punch(problem, 60).traction(x).text);
    const Decimal coarse = ClnClosedForm::parabola(curved, 60)[0].traction(x);
    CHECK(near(coarse, ClnClosedForm::parabola(curved, 120)[0].traction(x).value, 60));
  }
  // As near to an end as a user may come: distances are exact.
  const Rational near_end = -1 + parse_rational("1e-400");
  CHECK(rounded(ClnClosedForm::flat_punch(problem, 120).traction(near_end).value, 60).text ==
        ClnClosedForm::flat_punch(problem, 60).traction(near_end).text);
}

TEST_CASE("a punch scales: t(m + h x) on [m-h, m+h] is t(x)/h on [-1, 1], and t grows with the load") {
  const Rational h(3, 7);
  const Rational m(11, 5);
  const auto reference = ClnClosedForm::flat_punch(punch(Rational(2, 7), {1, 2}, {Rational(1, 3)}), 60);
  const auto moved = ClnClosedForm::flat_punch(punch(Rational(2, 7), {1, 2}, {m + h / 3}, m - h, m + h), 60);
  for (const Rational& x : {Rational(-1, 2), Rational(1, 2)}) {
    CHECK(near(moved.traction(m + h * x), reference.traction(x).value / h, 59));
    const auto heavier =
        ClnClosedForm::flat_punch(punch(Rational(2, 7), {1, 2}, {Rational(1, 3)}, -1, 1, Sliding::plus_x, 3), 60);
    CHECK(near(heavier.traction(x), 3 * reference.traction(x).value, 59));
  }
}

TEST_CASE("a parabola moves with its vertex and its jumps") {
  const std::vector<Rational> s{Rational(1, 5), 3, Rational(1, 10)};
  const Rational v(-7, 3);
  const auto here = ClnClosedForm::parabola(parabola(s, {Rational(-1, 4), Rational(1, 10)}), 60);
  const auto there =
      ClnClosedForm::parabola(parabola(s, {v - Rational(1, 4), v + Rational(1, 10)}, Rational(1, 5), v), 60);
  REQUIRE(here.size() == 1);
  REQUIRE(there.size() == 1);
  CHECK(near(there[0].left(), v + here[0].left().value, 59));
  CHECK(near(there[0].right(), v + here[0].right().value, 59));
  CHECK(near(there[0].traction(v + Rational(1, 20)), here[0].traction(Rational(1, 20)).value, 59));
}

TEST_CASE("the user's units: psi is divided by the compliance, the traction by nothing") {
  const Solid body(Rational(3, 10), 210);
  const Elasticity elasticity(body);
  const FrictionProfile friction({1, 2}, {Rational(1, 10)});
  const auto solved = [&](const Elasticity& constants, const Rational& a) {
    const Indenter bowl(-1, {{1, Polynomial({5, a / 3, a})}});
    return ClnClosedForm::parabola(ContactProblem(constants, friction, bowl, 2), 60);
  };
  const auto user = solved(elasticity, Rational(1, 4));
  const auto reduced = solved(Elasticity::reduced(elasticity.gamma()), Rational(1, 4) / elasticity.compliance());
  REQUIRE(user.size() == 1);
  REQUIRE(reduced.size() == 1);
  CHECK(user[0].left().text == reduced[0].left().text);
  CHECK(user[0].right().text == reduced[0].right().text);
  const Rational x = user[0].left().value / 3 + user[0].right().value * 2 / 3;
  CHECK(near(user[0].traction(x), reduced[0].traction(x).value, 59));
  CHECK(user[0].traction(x).value < 0);
  // Twice the load under twice the curvature: the same zone, twice the traction.
  const Indenter sharper(-1, {{1, Polynomial({5, Rational(1, 6), Rational(1, 2)})}});
  const auto doubled = ClnClosedForm::parabola(ContactProblem(elasticity, friction, sharper, 4), 60);
  REQUIRE(doubled.size() == 1);
  CHECK(doubled[0].left().text == user[0].left().text);
  CHECK(near(doubled[0].traction(x), 2 * user[0].traction(x).value, 59));
}

TEST_CASE("sliding the other way is the mirrored problem") {
  const std::vector<Rational> f{Rational(1, 5), 3, Rational(1, 10)};
  const std::vector<Rational> mirrored_f{Rational(1, 10), 3, Rational(1, 5)};
  const auto one = punch(Rational(2, 7), f, {Rational(-1, 4), Rational(1, 3)});
  const auto two = punch(Rational(2, 7), mirrored_f, {Rational(-1, 3), Rational(1, 4)}, -1, 1, Sliding::minus_x);
  const auto p =
      ClnClosedForm::parabola(parabola(f, {Rational(-1, 4), Rational(1, 10)}, Rational(1, 5), Rational(1, 8)), 60);
  const auto q = ClnClosedForm::parabola(parabola(mirrored_f, {Rational(-1, 10), Rational(1, 4)}, Rational(1, 5),
                                                  Rational(-1, 8), 1, 10, Sliding::minus_x),
                                         60);
  REQUIRE(p.size() == q.size());
  REQUIRE(p.size() == 1);
  CHECK(near(p[0].left(), -q[0].right().value, 59));
  CHECK(near(p[0].right(), -q[0].left().value, 59));
  for (const Rational& x : {Rational(-1, 5), Rational(-1, 10), Rational(1, 20), Rational(1, 5)}) {
    CHECK(near(ClnClosedForm::flat_punch(one, 60).traction(x), ClnClosedForm::flat_punch(two, 60).traction(-x).value,
               59));
    CHECK(near(p[0].traction(x), q[0].traction(-x).value, 59));
  }
}

TEST_CASE("parabola without jump: zone [-(1+2 alpha) a, (1-2 alpha) a], a^2 = P R/(2 pi (1/4 - alpha^2))") {
  for (const Rational& s : {Rational(0), Rational(1, 7), Rational(-3), Rational(20), Rational(1000000)}) {
    const Rational gamma = s < 0 ? Rational(-1, 2) : Rational(1, 2);
    const ContactProblem problem(Elasticity::reduced(gamma), FrictionProfile({abs(s) * 2}),
                                 Indenter(-2000, {{2000, Polynomial({0, 0, Rational(5, 2)})}}), 1);
    const auto found = ClnClosedForm::parabola(problem, 60);
    REQUIRE(found.size() == 1);
    const Rational alpha = cln_value(Exponent::angle(s), 80).value;
    const Rational square = Rational(1, 10) * one_over_pi / (Rational(1, 4) - alpha * alpha);
    const Rational left = found[0].left().value / (1 + 2 * alpha);
    const Rational right = found[0].right().value / (1 - 2 * alpha);
    CHECK(abs(left * left / square - 1) < parse_rational("1e-58"));
    CHECK(abs(right * right / square - 1) < parse_rational("1e-58"));
    CHECK(left < 0);
    CHECK(right > 0);
  }
}

TEST_CASE("parabola without friction: t = -sqrt(a^2 - x^2)/R") {
  const auto found = ClnClosedForm::parabola(parabola({0}, {}, Rational(1, 5), 0, 3), 60);
  REQUIRE(found.size() == 1);
  const Rational square = 2 * 3 * one_over_pi / 5;
  for (const Rational& x : {Rational(0), Rational(-1, 3), Rational(1, 7)}) {
    const Rational t = found[0].traction(x).value;
    CHECK(t < 0);
    CHECK(abs(t * t / (25 * (square - x * x)) - 1) < parse_rational("1e-58"));
  }
}

TEST_CASE("parabola with jumps: sum p r = 0, sum p r^2 = 2 P R/pi, on random problems") {
  int with_jumps = 0;
  CHECK(rc::check([&] {
    const auto random = [](int low, int high) { return Rational(uniform(low, high - 1), 60); };
    std::vector<Rational> jumps;
    for (Rational c = random(-60, 0); jumps.size() < 4 && c < 1; c += random(1, 60)) jumps.push_back(c);
    std::vector<Rational> s;
    for (std::size_t k = 0; k <= jumps.size(); ++k) s.push_back(random(0, 180));
    const Rational radius = random(1, 60);
    const ContactProblem problem = parabola(s, jumps, radius, 0, 1, 100);
    const auto found = ClnClosedForm::parabola(problem, 60);
    RC_ASSERT(!found.empty());
    for (const ClnClosedForm& form : found) {
      with_jumps += form.last_jump() > form.first_jump();
      const Rational a = form.left().value;
      const Rational b = form.right().value;
      const Rational pa = cln_value(free_exponent(End::left, s[form.first_jump()]), 70).value;
      const Rational pb = cln_value(free_exponent(End::right, s[form.last_jump()]), 70).value;
      Rational one = pa * a + pb * b;
      Rational two = pa * a * a + pb * b * b;
      for (std::size_t k = form.first_jump(); k < form.last_jump(); ++k) {
        const Rational beta = cln_value(jump_exponent(s[k], s[k + 1]), 70).value;
        RC_ASSERT(a < jumps[k]);
        RC_ASSERT(jumps[k] < b);
        one += beta * jumps[k];
        two += beta * jumps[k] * jumps[k];
      }
      RC_ASSERT(abs(one) < parse_rational("1e-57"));
      RC_ASSERT(abs(two - 2 * radius * one_over_pi) < parse_rational("1e-57"));
    }
  }));
  CHECK(with_jumps > 20);
}

TEST_CASE("the jumps inside the contact are found") {
  const std::vector<Rational> s{Rational(1, 10), Rational(3, 5), Rational(1, 5), Rational(1, 2)};
  const auto all = parabola(s, {Rational(-1, 10), 0, Rational(1, 10)});
  const auto one = parabola(s, {Rational(-1), 0, Rational(1)});
  const auto none = parabola(s, {Rational(-3), -2, -1});
  CHECK(ClnClosedForm::parabola(all, 40)[0].first_jump() == 0);
  CHECK(ClnClosedForm::parabola(all, 40)[0].last_jump() == 3);
  CHECK(ClnClosedForm::parabola(one, 40)[0].first_jump() == 1);
  CHECK(ClnClosedForm::parabola(one, 40)[0].last_jump() == 2);
  CHECK(ClnClosedForm::parabola(none, 40)[0].first_jump() == ClnClosedForm::parabola(none, 40)[0].last_jump());
  // Friction outside the contact is of no consequence.
  CHECK(ClnClosedForm::parabola(one, 40)[0].left().text ==
        ClnClosedForm::parabola(parabola({Rational(3, 5), Rational(1, 5)}, {0}), 40)[0].left().text);
  CHECK(ClnClosedForm::parabola(none, 40)[0].left().text ==
        ClnClosedForm::parabola(parabola({Rational(1, 2)}, {}), 40)[0].left().text);
  // Too heavy a load: the contact reaches both edges; or one of them only, the vertex being near.
  CHECK(ClnClosedForm::parabola(parabola({0}, {}, 1, 0, 100, 1), 40).empty());
  CHECK(ClnClosedForm::parabola(parabola({0}, {}, Rational(1, 5), Rational(-9, 10), 1, 1), 40).empty());
  CHECK(ClnClosedForm::parabola(parabola({0}, {}, Rational(1, 5), Rational(9, 10), 1, 1), 40).empty());
  CHECK(ClnClosedForm::parabola(parabola({0}, {}, Rational(1, 5), Rational(6, 10), 1, 1), 40).size() == 1);
}

TEST_CASE("a jump at an end of the contact is counted once, as beside it") {
  // The end is irrational: a jump placed there to far more digits than are carried lies on it for all that can be told.
  const auto free = ClnClosedForm::parabola(parabola({Rational(1, 3)}, {}), 200);
  const Rational left = free[0].left().value;
  const auto found = ClnClosedForm::parabola(parabola({Rational(1, 10), Rational(1, 3)}, {left}), 30);
  REQUIRE(found.size() == 1);
  CHECK(found[0].first_jump() == found[0].last_jump());
  CHECK(found[0].left().text == rounded(left, 30).text);
}
