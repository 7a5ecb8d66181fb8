#include "symbolic/riemann_hilbert/derived_contact.hpp"
#include "support/symbolic_test.hpp"
#include "symbolic/cln/cln_closed_form.hpp"
#include "symbolic/cln/cln_evaluation.hpp"

using namespace steadyslide::symbolic;

namespace {

ContactProblem problem(const std::vector<Rational>& s, const std::vector<Rational>& jumps,
                       const std::vector<Rational>& psi, const Rational& half_width = 1, const Rational& load = 1,
                       Sliding sliding = Sliding::plus_x) {
  return reduced(s, jumps, one_piece(-half_width, half_width, psi), load, std::nullopt, sliding);
}

/// The traction of the one contact there is.
Decimal only_traction(const ContactProblem& problem, const Rational& x, int digits) {
  const std::vector<DerivedContact> contacts = DerivedContact::all(problem, digits);
  REQUIRE(contacts.size() == 1);
  return contacts[0].traction(x);
}

}  // namespace

TEST_CASE("derived tractions are the closed forms, on random flat punches and parabolas") {
  int with_jumps = 0;
  CHECK(rc::check([&] {
    const auto [jumps, s] = random_friction();
    const Sliding sliding = uniform(0, 1) == 0 ? Sliding::plus_x : Sliding::minus_x;
    const Rational load = sixtieths(1, 120), x = sixtieths(-59, 60) + 0.001_r;

    const ContactProblem flat = problem(s, jumps, {}, 1, load, sliding);
    RC_ASSERT(near(only_traction(flat, x, 60).value, ClnClosedForm::flat_punch(flat, 60).traction(x).value, 59));

    const Rational vertex = sixtieths(-30, 30), a = sixtieths(1, 600);
    const ContactProblem curved = problem(s, jumps, {a * vertex * vertex, -2 * a * vertex, a}, 100, load, sliding);
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
    const Rational right = one_over_pi / (1 + 2 * alpha), left = -one_over_pi / (1 - 2 * alpha);
    const Rational little = 1e-20_r;
    const auto kinds = [&](const Rational& tilt) {
      const auto found = DerivedContact::all(problem({s}, {}, {0, tilt}), 40);
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
  const auto found = DerivedContact::all(problem({0}, {}, {0, 0, 0.5_r}, 1, 2), 40);
  REQUIRE(found.size() == 1);
  CHECK(found[0].kind(End::left) == SingularKind::edge);
  const Rational t = found[0].traction(0.6_r).value;
  const Rational expected = -(2 * one_over_pi - (0.36_r - 0.5_r)) / 0.8_r;
  CHECK(near(t, expected, 39));
  // P/pi < 1/(2R): the edges are free.
  CHECK(DerivedContact::all(problem({0}, {}, {0, 0, 0.5_r}), 40)[0].kind(End::left) == SingularKind::free);
}

TEST_CASE("what has no derived traction here is refused") {
  CHECK_THROWS_AS(only_traction(problem({0}, {}, {0, 0, -1}), 0, 30), std::domain_error);
  CHECK_THROWS_AS(only_traction(problem({0}, {}, {0, 0, 0, 1}), 0, 30), std::domain_error);
  const ContactProblem flat = problem({0, 1}, {0}, {});
  CHECK_THROWS_AS(only_traction(flat, 0, 30), std::domain_error);
  CHECK_THROWS_AS(only_traction(flat, 1, 30), std::domain_error);
  CHECK_THROWS_AS(only_traction(flat, 0.5_r, 0), std::domain_error);
  CHECK(only_traction(flat, 2, 30).text == "0");
}
