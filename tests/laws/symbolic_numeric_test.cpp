// Compares the derived tractions, evaluated in CLN at 60 digits, with the closed forms of the numeric layer in MPFR.

#include "numeric/closed_form/closed_form.hpp"
#include "support/numeric_test.hpp"
#include "support/random_problem.hpp"
#include "symbolic/riemann_hilbert/derived_contact.hpp"

using steadyslide::symbolic::DerivedContact;

namespace {

/// Agreement to 48 digits, relative.
bool agree(const symbolic::Decimal& derived, const Real50& value) {
  const Real50 expected = to_real<Real50>(derived.value);
  return abs(value - expected) <= Real50("1e-48") * abs(expected);
}

void derived_equals_numeric(const ContactProblem& problem, int& compared) {
  const auto contacts = DerivedContact::all(problem, 60);
  RC_ASSERT(contacts.size() == 1U);
  const auto solution = closed_form<Real50>(problem).solution;
  const auto contact = solution->contact().front();
  RC_ASSERT(contact.left.kind == contacts[0].kind(End::left));
  RC_ASSERT(contact.right.kind == contacts[0].kind(End::right));
  RC_ASSERT(agree(contacts[0].end(End::left), contact.left.x.value));
  RC_ASSERT(agree(contacts[0].end(End::right), contact.right.x.value));
  const Rational left(static_cast<double>(contact.left.x.value));
  const Rational width = Rational(static_cast<double>(contact.right.x.value)) - left;
  for (const Rational& part : {Rational(1, 1009), Rational(311, 1009), Rational(887, 1009), Rational(1008, 1009)}) {
    const Rational x = left + part * width;
    const auto& jumps = problem.friction().jumps();
    if (std::find(jumps.begin(), jumps.end(), x) != jumps.end()) continue;
    RC_ASSERT(agree(contacts[0].traction(x), solution->at(x).traction.left.value));
    ++compared;
  }
}

}  // namespace

TEST_CASE("200 random problems: derived and numeric tractions agree to 48 digits") {
  int compared = 0;
  CHECK(rc::check("flat punches", [&] { derived_equals_numeric(*flat_punch(4), compared); }));
  CHECK(rc::check("parabolas", [&] { derived_equals_numeric(*parabola(3), compared); }));
  MESSAGE("tractions compared: " << compared);
  CHECK(compared > 700);
}

TEST_CASE("control: the mirrored friction is another traction") {
  const ContactProblem problem(Elasticity(Solid(0, 1)), FrictionProfile({1, 2}, {0}), Indenter(-1, {{1, Polynomial()}}),
                               1);
  const ContactProblem mirrored = problem.with_friction(FrictionProfile({2, 1}, {0}));
  const Rational x(1, 3);
  const Real50 value = closed_form<Real50>(problem).solution->at(x).traction.left.value;
  CHECK(agree(DerivedContact::all(problem, 60).at(0).traction(x), value));
  CHECK(!agree(DerivedContact::all(mirrored, 60).at(0).traction(x), value));
}
