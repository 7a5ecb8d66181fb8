#include "model/singular_point.hpp"
#include "support/change_laws.hpp"
#include "support/symbolic_test.hpp"
#include "symbolic/cln/cln_evaluation.hpp"
#include "symbolic/riemann_hilbert/derived_contact.hpp"

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

/// Returns the one contact there is.
DerivedContact contact(const ContactProblem& problem, int digits = 60) {
  const std::vector<DerivedContact> all = DerivedContact::all(problem, digits);
  if (all.size() != 1) throw std::logic_error("not one contact");
  return all.front();
}

}  // namespace

TEST_CASE("flat punch without jump: [Bal16, (4)], its powers taken apart by hand") {
  // gamma f = 1: alpha = 1/4 and t(x) = -(P/pi) cos(pi/4) (1+x)^(-3/4) (1-x)^(-1/4).
  const DerivedContact form = contact(punch(0.5_r, {2}, {}));
  CHECK(form.end(End::left).value == -1);
  CHECK(form.end(End::right).value == 1);
  // 1/(sqrt(2) pi), mpmath at 80 digits.
  CHECK(form.traction(0).text == "-0.225079079039276517388799797751685145666143537488805156392859");
  // (t(3/5)/t(0))^4 = (8/5)^-3 (2/5)^-1.
  const Rational ratio = form.traction(0.6_r).value / form.traction(0).value;
  CHECK(abs(ratio * ratio * ratio * ratio - Rational(625, 1024)) < 1e-58_r);
}

TEST_CASE("traction where it is not defined is refused, outside the contact it is zero") {
  const DerivedContact form = contact(punch(Rational(2, 7), {0.2_r, 0.6_r, 0.6_r}, {0, 0.5_r}), 30);
  CHECK_THROWS_AS(form.traction(-1), std::domain_error);
  CHECK_THROWS_AS(form.traction(1), std::domain_error);
  CHECK_THROWS_AS(form.traction(0), std::domain_error);
  CHECK(form.traction(0.5_r).value < 0);  // a jump of height zero is not a singular point
  CHECK(form.traction(2).text == "0");
  CHECK(form.traction(-2).text == "0");
}

TEST_CASE("more digits extend fewer digits") {
  const std::vector<Rational> f{0.2_r, 3, 0.1_r, 50};
  const std::vector<Rational> jumps{-0.25_r, Rational(1, 3), Rational(2, 3)};
  const auto problem = punch(Rational(2, 7), f, jumps);
  const auto curved = parabola(f, jumps);
  for (const Rational& x : {-0.9_r, 0.1_r, 0.333333_r, -0.3_r}) {
    CHECK(rounded(contact(problem, 120).traction(x).value, 60).text == contact(problem).traction(x).text);
    CHECK(near(contact(curved).traction(x).value, contact(curved, 120).traction(x).value, 60));
  }
  // Places very near to an end: distances are exact.
  const Rational near_end = -1 + 1e-400_r;
  CHECK(rounded(contact(problem, 120).traction(near_end).value, 60).text == contact(problem).traction(near_end).text);
}

TEST_CASE("a punch scales, a parabola moves: the laws of changed problems") {
  const std::vector<ChangeLaw>& laws = change_laws();
  CHECK(rc::check([&] {
    const ContactProblem p = *rc::gen::oneOf(flat_punch(3), parabola(3));
    const DerivedContact here = contact(p);
    const Rational left = here.end(End::left).value, length = here.end(End::right).value - left;
    const ChangeLaw& law = laws[static_cast<std::size_t>(uniform(0, static_cast<int>(laws.size()) - 1))];
    RC_LOG() << law.name << '\n';
    const auto [changed, image] = law.change(p, some_factor(), left + length * 271 / 1009);
    const DerivedContact there = contact(changed);
    const bool mirror = image.scale < 0;
    const auto is_end = [&, &image = image](const Decimal& end, const Rational& expected) {
      return abs(end.value - image.of(expected)) <= 1e-58_r * (abs(end.value) + abs(image.scale) * length);
    };
    RC_ASSERT(is_end(there.end(mirror ? End::right : End::left), left));
    RC_ASSERT(is_end(there.end(mirror ? End::left : End::right), left + length));
    for (const int part : {13, 271, 502, 838}) {
      const Rational x = left + length * part / 1009;
      RC_ASSERT(near(there.traction(image.of(x)).value, image.traction * here.traction(x).value, 57));
    }
  }));
}

TEST_CASE("control: a scaled and a mirrored punch are other ones") {
  const auto p = punch(Rational(2, 7), {1, 2}, {Rational(1, 3)});
  const Rational t = contact(p).traction(0.5_r).value;
  CHECK_FALSE(near(contact(p.moved(2, 0)).traction(1).value, t, 20));
  CHECK_FALSE(near(contact(p.moved(-1, 0).with_sliding(p.sliding())).traction(-0.5_r).value, t, 20));
}

TEST_CASE("parabola without jump: zone [-(1+2 alpha) a, (1-2 alpha) a], a^2 = P R/(2 pi (1/4 - alpha^2))") {
  for (const Rational& s : {0_r, Rational(1, 7), Rational(-3), 20_r, 1000000_r}) {
    const Rational gamma = s < 0 ? -0.5_r : 0.5_r;
    const ContactProblem problem(Elasticity::reduced(gamma), FrictionProfile({abs(s) * 2}),
                                 Indenter(-2000, {{2000, Polynomial({0, 0, 2.5_r})}}), 1);
    const DerivedContact found = contact(problem);
    const Rational alpha = cln_value(Exponent::angle(s), 80).value;
    const Rational square = 0.1_r * one_over_pi / (0.25_r - alpha * alpha);
    const Rational left = found.end(End::left).value / (1 + 2 * alpha);
    const Rational right = found.end(End::right).value / (1 - 2 * alpha);
    CHECK(abs(left * left / square - 1) < 1e-58_r);
    CHECK(abs(right * right / square - 1) < 1e-58_r);
    CHECK(left < 0);
    CHECK(right > 0);
  }
}

TEST_CASE("parabola without friction: t = -sqrt(a^2 - x^2)/R") {
  const DerivedContact found = contact(parabola({0}, {}, 0.2_r, 0, 3));
  const Rational square = 2 * 3 * one_over_pi / 5;
  for (const Rational& x : {0_r, Rational(-1, 3), Rational(1, 7)}) {
    const Rational t = found.traction(x).value;
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
    const auto found = DerivedContact::all(problem, 60);
    RC_ASSERT(!found.empty());
    for (const DerivedContact& form : found) {
      const Rational a = form.end(End::left).value, b = form.end(End::right).value;
      RC_ASSERT((form.kind(End::left) == SingularKind::free && form.kind(End::right) == SingularKind::free));
      const FrictionProfile friction(s, jumps);
      const std::size_t first = friction.piece(a, Side::right), last = friction.piece(b, Side::left);
      with_jumps += last > first;
      const Rational pa = cln_value(free_exponent(End::left, s[first]), 70).value;
      const Rational pb = cln_value(free_exponent(End::right, s[last]), 70).value;
      Rational one = pa * a + pb * b, two = pa * a * a + pb * b * b;
      for (std::size_t k = first; k < last; ++k) {
        const Rational beta = cln_value(jump_exponent(s[k], s[k + 1]), 70).value;
        one += beta * jumps[k];
        two += beta * jumps[k] * jumps[k];
      }
      RC_ASSERT(abs(one) < 1e-57_r);
      RC_ASSERT(abs(two - 2 * radius * one_over_pi) < 1e-57_r);
    }
  }));
  CHECK(with_jumps > 20);
}

TEST_CASE("friction outside the contact has no effect, and a large load brings the contact to an edge") {
  const std::vector<Rational> s{0.1_r, 0.6_r, 0.2_r, 0.5_r};
  const auto left = [](const ContactProblem& p) { return contact(p, 40).end(End::left).text; };
  CHECK(left(parabola(s, {-1, 0, 1})) == left(parabola({0.6_r, 0.2_r}, {0})));
  CHECK(left(parabola(s, {-3, -2, -1})) == left(parabola({0.5_r}, {})));
  CHECK(left(parabola(s, {-0.1_r, 0, 0.1_r})) != left(parabola({0.6_r, 0.2_r}, {0})));
  const auto kinds = [](const ContactProblem& p) {
    const DerivedContact found = contact(p, 40);
    return std::pair(found.kind(End::left), found.kind(End::right));
  };
  using Kind = SingularKind;
  CHECK(kinds(parabola({0}, {}, 1, 0, 100, 1)) == std::pair(Kind::edge, Kind::edge));
  CHECK(kinds(parabola({0}, {}, 0.2_r, -0.9_r, 1, 1)) == std::pair(Kind::edge, Kind::free));
  CHECK(kinds(parabola({0}, {}, 0.2_r, 0.9_r, 1, 1)) == std::pair(Kind::free, Kind::edge));
  CHECK(kinds(parabola({0}, {}, 0.2_r, 0.6_r, 1, 1)) == std::pair(Kind::free, Kind::free));
}

TEST_CASE("a jump at an end of the contact is counted once, as beside it") {
  // The end is irrational. A jump is placed there with far more digits than are used: it cannot be distinguished from
  // the end.
  const Rational left = contact(parabola({Rational(1, 3)}, {}), 200).end(End::left).value;
  CHECK(contact(parabola({0.1_r, Rational(1, 3)}, {left}), 30).end(End::left).text == rounded(left, 30).text);
}
