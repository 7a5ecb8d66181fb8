#include "symbolic/cln/cln_closed_form.hpp"
#include "model/singular_point.hpp"
#include "support/change_laws.hpp"
#include "support/symbolic_test.hpp"
#include "symbolic/cln/cln_evaluation.hpp"

using namespace steadyslide::symbolic;

namespace {

ContactProblem punch(const Rational& gamma, std::vector<Rational> f, std::vector<Rational> jumps,
                     const Rational& left = -1, const Rational& right = 1, Sliding sliding = Sliding::plus_x,
                     const Rational& load = 1) {
  return ContactProblem(Elasticity::reduced(gamma), FrictionProfile(std::move(f), std::move(jumps)),
                        Indenter(left, {{right, Polynomial()}}), load, sliding);
}

/// psi = (x - vertex)^2 / (2 radius).
ContactProblem parabola(const std::vector<Rational>& s, const std::vector<Rational>& jumps,
                        const Rational& radius = 0.2_r, const Rational& vertex = 0, const Rational& load = 1,
                        const Rational& half_width = 10) {
  const Rational a = 1 / (2 * radius);
  return reduced(s, jumps, one_piece(-half_width, half_width, {a * vertex * vertex, -2 * a * vertex, a}), load);
}

}  // namespace

TEST_CASE("flat punch without jump: [Bal16, (4)], its powers taken apart by hand") {
  // gamma f = 1: alpha = 1/4 and t(x) = -(P/pi) cos(pi/4) (1+x)^(-3/4) (1-x)^(-1/4).
  const ClnClosedForm form = ClnClosedForm::flat_punch(punch(0.5_r, {2}, {}), 60);
  CHECK(form.left().value == -1);
  CHECK(form.right().value == 1);
  CHECK(form.first_jump() == form.last_jump());
  // 1/(sqrt(2) pi), mpmath at 80 digits.
  CHECK(form.traction(0).text == "-0.225079079039276517388799797751685145666143537488805156392859");
  // (t(3/5)/t(0))^4 = (8/5)^-3 (2/5)^-1.
  const Rational ratio = form.traction(0.6_r).value / form.traction(0).value;
  CHECK(abs(ratio * ratio * ratio * ratio - Rational(625, 1024)) < 1e-58_r);
}

TEST_CASE("traction where it is not defined is refused, outside the contact it is zero") {
  const ClnClosedForm form = ClnClosedForm::flat_punch(punch(Rational(2, 7), {0.2_r, 0.6_r, 0.6_r}, {0, 0.5_r}), 30);
  CHECK_THROWS_AS(form.traction(-1), std::domain_error);
  CHECK_THROWS_AS(form.traction(1), std::domain_error);
  CHECK_THROWS_AS(form.traction(0), std::domain_error);
  CHECK(form.traction(0.5_r).value < 0);  // a jump of height zero is not a singular point
  CHECK(form.traction(2).text == "0");
  CHECK(form.traction(-2).text == "0");
  CHECK_THROWS_AS(ClnClosedForm::flat_punch(punch(Rational(2, 7), {1}, {}), 0), std::domain_error);
  CHECK_THROWS_AS(ClnClosedForm::flat_punch(parabola({0}, {}), 30), std::domain_error);
  CHECK_THROWS_AS(ClnClosedForm::parabola(punch(Rational(2, 7), {1}, {}), 30), std::domain_error);
}

TEST_CASE("more digits extend fewer digits") {
  const std::vector<Rational> f{0.2_r, 3, 0.1_r, 50};
  const std::vector<Rational> jumps{-0.25_r, Rational(1, 3), Rational(2, 3)};
  const auto problem = punch(Rational(2, 7), f, jumps);
  const auto curved = parabola(f, jumps);
  REQUIRE(ClnClosedForm::parabola(curved, 60).size() == 1);
  for (const Rational& x : {-0.9_r, 0.1_r, 0.333333_r, -0.3_r}) {
    CHECK(rounded(ClnClosedForm::flat_punch(problem, 120).traction(x).value, 60).text ==
          ClnClosedForm::flat_punch(problem, 60).traction(x).text);
    const Decimal coarse = ClnClosedForm::parabola(curved, 60)[0].traction(x);
    CHECK(near(coarse.value, ClnClosedForm::parabola(curved, 120)[0].traction(x).value, 60));
  }
  // Places very near to an end: distances are exact.
  const Rational near_end = -1 + 1e-400_r;
  CHECK(rounded(ClnClosedForm::flat_punch(problem, 120).traction(near_end).value, 60).text ==
        ClnClosedForm::flat_punch(problem, 60).traction(near_end).text);
}

TEST_CASE("a punch scales, a parabola moves: the laws of changed problems") {
  const auto form = [](const ContactProblem& p) {
    const bool flat = p.indenter().pieces()[0].profile.degree() <= 0;
    const auto all = flat ? std::vector{ClnClosedForm::flat_punch(p, 60)} : ClnClosedForm::parabola(p, 60);
    if (all.size() != 1) throw std::logic_error("not one contact");
    return all.front();
  };
  const std::vector<ChangeLaw>& laws = change_laws();
  CHECK(rc::check([&] {
    const ContactProblem p = *rc::gen::oneOf(flat_punch(3), parabola(3));
    const ClnClosedForm here = form(p);
    const Rational left = here.left().value, length = here.right().value - left;
    const ChangeLaw& law = laws[static_cast<std::size_t>(uniform(0, static_cast<int>(laws.size()) - 1))];
    RC_LOG() << law.name << '\n';
    const auto [changed, image] = law.change(p, some_factor(), left + length * 271 / 1009);
    const ClnClosedForm there = form(changed);
    const bool mirror = image.scale < 0;
    const auto is_end = [&](const Decimal& end, const Rational& expected) {
      return abs(end.value - image.of(expected)) <= 1e-58_r * (abs(end.value) + abs(image.scale) * length);
    };
    RC_ASSERT(is_end(mirror ? there.right() : there.left(), left));
    RC_ASSERT(is_end(mirror ? there.left() : there.right(), left + length));
    for (const int part : {13, 271, 502, 838}) {
      const Rational x = left + length * part / 1009;
      RC_ASSERT(near(there.traction(image.of(x)).value, image.traction * here.traction(x).value, 57));
    }
  }));
}

TEST_CASE("control: a scaled and a mirrored punch are other ones") {
  const auto p = punch(Rational(2, 7), {1, 2}, {Rational(1, 3)});
  const Rational t = ClnClosedForm::flat_punch(p, 60).traction(0.5_r).value;
  CHECK_FALSE(near(ClnClosedForm::flat_punch(p.moved(2, 0), 60).traction(1).value, t, 20));
  CHECK_FALSE(
      near(ClnClosedForm::flat_punch(p.moved(-1, 0).with_sliding(p.sliding()), 60).traction(-0.5_r).value, t, 20));
}

TEST_CASE("parabola without jump: zone [-(1+2 alpha) a, (1-2 alpha) a], a^2 = P R/(2 pi (1/4 - alpha^2))") {
  for (const Rational& s : {0_r, Rational(1, 7), Rational(-3), 20_r, 1000000_r}) {
    const Rational gamma = s < 0 ? -0.5_r : 0.5_r;
    const ContactProblem problem(Elasticity::reduced(gamma), FrictionProfile({abs(s) * 2}),
                                 Indenter(-2000, {{2000, Polynomial({0, 0, 2.5_r})}}), 1);
    const auto found = ClnClosedForm::parabola(problem, 60);
    REQUIRE(found.size() == 1);
    const Rational alpha = cln_value(Exponent::angle(s), 80).value;
    const Rational square = 0.1_r * one_over_pi / (0.25_r - alpha * alpha);
    const Rational left = found[0].left().value / (1 + 2 * alpha);
    const Rational right = found[0].right().value / (1 - 2 * alpha);
    CHECK(abs(left * left / square - 1) < 1e-58_r);
    CHECK(abs(right * right / square - 1) < 1e-58_r);
    CHECK(left < 0);
    CHECK(right > 0);
  }
}

TEST_CASE("parabola without friction: t = -sqrt(a^2 - x^2)/R") {
  const auto found = ClnClosedForm::parabola(parabola({0}, {}, 0.2_r, 0, 3), 60);
  REQUIRE(found.size() == 1);
  const Rational square = 2 * 3 * one_over_pi / 5;
  for (const Rational& x : {0_r, Rational(-1, 3), Rational(1, 7)}) {
    const Rational t = found[0].traction(x).value;
    CHECK(t < 0);
    CHECK(abs(t * t / (25 * (square - x * x)) - 1) < 1e-58_r);
  }
}

TEST_CASE("parabola with jumps: sum p r = 0, sum p r^2 = 2 P R/pi, on random problems") {
  int with_jumps = 0;
  CHECK(rc::check([&] {
    const auto [jumps, s] = random_friction();
    const Rational radius = sixtieths(1, 60);
    const ContactProblem problem = parabola(s, jumps, radius, 0, 1, 100);
    const auto found = ClnClosedForm::parabola(problem, 60);
    RC_ASSERT(!found.empty());
    for (const ClnClosedForm& form : found) {
      with_jumps += form.last_jump() > form.first_jump();
      const Rational a = form.left().value, b = form.right().value;
      const Rational pa = cln_value(free_exponent(End::left, s[form.first_jump()]), 70).value;
      const Rational pb = cln_value(free_exponent(End::right, s[form.last_jump()]), 70).value;
      Rational one = pa * a + pb * b, two = pa * a * a + pb * b * b;
      for (std::size_t k = form.first_jump(); k < form.last_jump(); ++k) {
        const Rational beta = cln_value(jump_exponent(s[k], s[k + 1]), 70).value;
        RC_ASSERT(a < jumps[k]);
        RC_ASSERT(jumps[k] < b);
        one += beta * jumps[k];
        two += beta * jumps[k] * jumps[k];
      }
      RC_ASSERT(abs(one) < 1e-57_r);
      RC_ASSERT(abs(two - 2 * radius * one_over_pi) < 1e-57_r);
    }
  }));
  CHECK(with_jumps > 20);
}

TEST_CASE("the jumps inside the contact are found") {
  const std::vector<Rational> s{0.1_r, 0.6_r, 0.2_r, 0.5_r};
  const auto solved = [](const ContactProblem& p) { return ClnClosedForm::parabola(p, 40).at(0); };
  const ClnClosedForm all = solved(parabola(s, {-0.1_r, 0, 0.1_r}));
  const ClnClosedForm one = solved(parabola(s, {-1, 0, 1})), none = solved(parabola(s, {-3, -2, -1}));
  CHECK(all.first_jump() == 0);
  CHECK(all.last_jump() == 3);
  CHECK(one.first_jump() == 1);
  CHECK(one.last_jump() == 2);
  CHECK(none.first_jump() == none.last_jump());
  // Friction outside the contact has no effect.
  CHECK(one.left().text == solved(parabola({0.6_r, 0.2_r}, {0})).left().text);
  CHECK(none.left().text == solved(parabola({0.5_r}, {})).left().text);
  // The load is too large: the contact reaches both edges, or one of them if the vertex is near.
  CHECK(ClnClosedForm::parabola(parabola({0}, {}, 1, 0, 100, 1), 40).empty());
  CHECK(ClnClosedForm::parabola(parabola({0}, {}, 0.2_r, -0.9_r, 1, 1), 40).empty());
  CHECK(ClnClosedForm::parabola(parabola({0}, {}, 0.2_r, 0.9_r, 1, 1), 40).empty());
  CHECK(ClnClosedForm::parabola(parabola({0}, {}, 0.2_r, 0.6_r, 1, 1), 40).size() == 1);
}

TEST_CASE("a jump at an end of the contact is counted once, as beside it") {
  // The end is irrational. A jump is placed there with far more digits than are used: it cannot be distinguished from
  // the end.
  const auto free = ClnClosedForm::parabola(parabola({Rational(1, 3)}, {}), 200);
  const Rational left = free[0].left().value;
  const auto found = ClnClosedForm::parabola(parabola({0.1_r, Rational(1, 3)}, {left}), 30);
  REQUIRE(found.size() == 1);
  CHECK(found[0].first_jump() == found[0].last_jump());
  CHECK(found[0].left().text == rounded(left, 30).text);
}
