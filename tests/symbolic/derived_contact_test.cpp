#include "symbolic/riemann_hilbert/derived_contact.hpp"
#include "support/test.hpp"
#include "symbolic/cln/cln_closed_form.hpp"
#include "symbolic/cln/cln_evaluation.hpp"

using namespace steadyslide::symbolic;

namespace {

/// gamma = 1/2: s = f/2.
ContactProblem problem(std::vector<Rational> s, std::vector<Rational> jumps, const Polynomial& psi,
                       const Rational& left = -1, const Rational& right = 1, const Rational& load = 1,
                       Sliding sliding = Sliding::plus_x) {
  for (Rational& value : s) value *= 2;
  return ContactProblem(Elasticity::reduced(0.5_r), FrictionProfile(std::move(s), std::move(jumps)),
                        Indenter(left, {{right, psi}}), load, sliding);
}

bool near(const Rational& a, const Rational& b, int digits) {
  const Integer scale = boost::multiprecision::pow(Integer(10), static_cast<unsigned>(digits));
  return abs(a - b) * scale <= abs(b) * 10;
}

/// -P cos(pi alpha)/pi and its like need 1/pi: mpmath at 80 digits.
const Rational one_over_pi = 0.31830988618379067153776752674502872406891929148091289749533468811779358_r;

}  // namespace

TEST_CASE("derived tractions are the closed forms, on random flat punches and parabolas") {
  int with_jumps = 0;
  CHECK(rc::check([&] {
    const auto random = [](int low, int high) { return Rational(uniform(low, high - 1), 60); };
    std::vector<Rational> jumps;
    for (Rational c = random(-59, 0); jumps.size() < 4 && c < 1; c += random(1, 60)) jumps.push_back(c);
    std::vector<Rational> s;
    for (std::size_t k = 0; k <= jumps.size(); ++k) s.push_back(random(0, 180));
    const Sliding sliding = uniform(0, 1) == 0 ? Sliding::plus_x : Sliding::minus_x;
    const Rational load = random(1, 120);
    const Rational x = random(-59, 60) + 0.001_r;

    const ContactProblem flat = problem(s, jumps, Polynomial(), -1, 1, load, sliding);
    RC_ASSERT(near(derived_traction(flat, x, 60).value, ClnClosedForm::flat_punch(flat, 60).traction(x).value, 59));

    const Rational vertex = random(-30, 30);
    const Polynomial from_vertex({-vertex, 1});
    const ContactProblem curved =
        problem(s, jumps, from_vertex * from_vertex * Polynomial({random(1, 600)}), -100, 100, load, sliding);
    const auto known = ClnClosedForm::parabola(curved, 60);
    const auto derived = DerivedContact::all(curved, 60);
    RC_ASSERT(derived.size() == known.size());
    for (std::size_t k = 0; k < known.size(); ++k) {
      with_jumps += known[k].last_jump() > known[k].first_jump();
      RC_ASSERT(near(derived[k].end(End::left).value, known[k].left().value, 58));
      RC_ASSERT(near(derived[k].end(End::right).value, known[k].right().value, 58));
      RC_ASSERT(derived[k].kind(End::left) == SingularKind::free);
      const Rational inside = (known[k].left().value * 2 + known[k].right().value) / 3;
      RC_ASSERT(near(derived[k].traction(inside).value, known[k].traction(inside).value, 57));
    }
  }));
  CHECK(with_jumps > 10);
}

TEST_CASE("a tilted punch: both edges carry until P/(pi (1+2 alpha)) and -P/(pi (1-2 alpha))") {
  for (const Rational& s : {0_r, Rational(1, 3), 2_r}) {
    const Rational alpha = cln_value(Exponent::angle(s), 60).value;
    const Rational right = one_over_pi / (1 + 2 * alpha);
    const Rational left = -one_over_pi / (1 - 2 * alpha);
    const Rational little = 1e-20_r;
    const auto kinds = [&](const Rational& tilt) {
      const auto found = DerivedContact::all(problem({s}, {}, Polynomial({0, tilt})), 40);
      REQUIRE(found.size() == 1);
      return std::pair(found[0].kind(End::left), found[0].kind(End::right));
    };
    const std::pair both(SingularKind::edge, SingularKind::edge);
    CHECK(kinds(right * (1 - little)) == both);
    CHECK(kinds(right * (1 + little)) == std::pair(SingularKind::edge, SingularKind::free));
    CHECK(kinds(left * (1 - little)) == both);
    CHECK(kinds(left * (1 + little)) == std::pair(SingularKind::free, SingularKind::edge));
  }
}

TEST_CASE("a parabola without friction in full contact, by hand") {
  // psi' = x/R on [-1, 1]: p = (P/pi - (x^2 - 1/2)/R)/sqrt(1-x^2), as long as P/pi >= 1/(2R).
  const auto found = DerivedContact::all(problem({0}, {}, Polynomial({0, 0, 0.5_r}), -1, 1, 2), 40);
  REQUIRE(found.size() == 1);
  CHECK(found[0].kind(End::left) == SingularKind::edge);
  const Rational t = found[0].traction(0.6_r).value;
  const Rational expected = -(2 * one_over_pi - (0.36_r - 0.5_r)) / 0.8_r;
  CHECK(near(t, expected, 39));
  // P/pi < 1/(2R): the edges are free.
  CHECK(DerivedContact::all(problem({0}, {}, Polynomial({0, 0, 0.5_r})), 40)[0].kind(End::left) == SingularKind::free);
}

TEST_CASE("what has no derived traction here is refused") {
  CHECK_THROWS_AS(derived_traction(problem({0}, {}, Polynomial({0, 0, -1})), 0, 30), std::domain_error);
  CHECK_THROWS_AS(derived_traction(problem({0}, {}, Polynomial({0, 0, 0, 1})), 0, 30), std::domain_error);
  const ContactProblem flat = problem({0, 1}, {0}, Polynomial());
  CHECK_THROWS_AS(derived_traction(flat, 0, 30), std::domain_error);
  CHECK_THROWS_AS(derived_traction(flat, 1, 30), std::domain_error);
  CHECK_THROWS_AS(derived_traction(flat, 0.5_r, 0), std::domain_error);
  CHECK(derived_traction(flat, 2, 30).text == "0");
}
