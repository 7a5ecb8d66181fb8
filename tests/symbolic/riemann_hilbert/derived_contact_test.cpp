#include "symbolic/riemann_hilbert/derived_contact.hpp"
#include "support/symbolic_test.hpp"
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

void check_says(const Derivation& derivation, std::initializer_list<const char*> parts) {
  for (const char* part : parts) CHECK_MESSAGE(holds(to_text(derivation), part), part);
}

}  // namespace

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

TEST_CASE("every kind of contact is derived with up to four jumps, in the same words every time") {
  // Punches: flat, tilted, with a lifted edge. Parabolas: free, against each edge, in full contact.
  const std::vector<std::vector<Rational>> profiles{
      {}, {0, 0.1_r}, {0, 1}, {0, 0, 2.5_r}, {0, 4, 2.5_r}, {0, -4, 2.5_r}, {0, 0, 0.01_r}};
  const std::vector<Rational> all_s{0.1_r, 0.6_r, 0.2_r, 0.5_r, 0.3_r}, all_jumps{-0.1_r, 0, 0.1_r, 0.2_r};
  for (const std::vector<Rational>& psi : profiles) {
    for (std::ptrdiff_t jumps = 0; jumps <= 4; ++jumps) {
      const ContactProblem one =
          problem({all_s.begin(), all_s.begin() + jumps + 1}, {all_jumps.begin(), all_jumps.begin() + jumps}, psi);
      const auto found = DerivedContact::all(one, 30), again = DerivedContact::all(one, 30);
      REQUIRE(found.size() == 1);
      const Derivation derivation = found[0].derivation();
      CHECK(std::ranges::count(derivation.steps, DerivationStep::Kind::result, &DerivationStep::kind) >= 8);
      CHECK(to_text(derivation) == to_text(again[0].derivation()));
      CHECK(to_latex(derivation) == to_latex(again[0].derivation()));
    }
  }
}

TEST_CASE("a problem's own derivation has its numbers") {
  check_says(DerivedContact::all(problem({0.1_r, 0.6_r}, {0}, {}), 30).at(0).derivation(),
             {"p_0 = -1/2 - alpha_0", "p_1 = alpha_0 - alpha_1", "p_2 = -1/2 + alpha_1", "S = -1", "N = -1/pi",
              "(s+i) Y+ = |Y|/cos(pi alpha)"});
  check_says(DerivedContact::all(problem({0.1_r, 0.6_r}, {0}, {0, 0, 2.5_r}), 30).at(0).derivation(),
             {"s_0 = 1/10", "s_1 = 3/5", "-0.40030177520230828358748137134", "0.2789364365421476101051427811", "N = 5",
              "(s+i) Y+ = -|Y|/cos(pi alpha)", "S = 1"});
}
