// The place of the load in full contact is compared with the solver for indenters that may tilt; shares and centre of
// pressure with the closed form.

#include "numeric/flat_punch/flat_punch.hpp"

#include "random_punch.hpp"
#include "support/solved_contact.hpp"

namespace {

/// True if both ends of the support are in contact, as edges.
bool in_full_contact(const ContactProblem& punch) {
  const auto contact = solved<double>(punch)->contact();
  return contact.size() == 1 && contact[0].left.kind == SingularKind::edge &&
         contact[0].right.kind == SingularKind::edge;
}

ContactProblem loaded_at(const ContactProblem& punch, const Rational& x) {
  return {punch.elasticity(), punch.friction(), punch.indenter(), punch.load(), punch.sliding(), x};
}

}  // namespace

TEST_CASE("the solver has full contact just inside the core, and none just outside") {
  for (const unsigned n : {1u, 2u, 3u, 5u}) {
    for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
      CAPTURE(n);
      const ContactProblem punch = random_punch(n).with_sliding(sliding).moved(2, 3);
      const PunchCore<double> core = *punch_core<double>(punch);
      CHECK(core.left.value < core.right.value);
      const Rational in(1, 1000);
      CHECK(in_full_contact(loaded_at(punch, Rational(core.left.value) + in)));
      CHECK(in_full_contact(loaded_at(punch, Rational(core.right.value) - in)));
      CHECK(!in_full_contact(loaded_at(punch, Rational(core.left.value) - in)));
      CHECK(!in_full_contact(loaded_at(punch, Rational(core.right.value) + in)));
    }
  }
}

TEST_CASE("without friction the middle half; the formula by moments of alpha") {
  const ContactProblem plain = reduced({0}, {}, one_piece(-1, 1, {0}), 1);
  CHECK(punch_core<double>(plain)->left.value == -0.5);
  CHECK(punch_core<double>(plain)->right.value == 0.5);
  for (unsigned n = 0; n < 18; ++n) {
    const auto layout = FrictionLayout<double>::of(random_punch(n));
    const double m0 = layout.moment(0);
    const double m1 = layout.moment(1);
    const PunchCore<double> core = *punch_core<double>(random_punch(n));
    CHECK(std::abs(core.left.value - (m1 / (1 + m0) - (1 + m0) / 2)) < 1e-12);
    CHECK(std::abs(core.right.value - ((1 - m0) / 2 - m1 / (1 - m0))) < 1e-12);
  }
}

TEST_CASE("digits agree with more digits, for large friction too") {
  for (const auto& s : {std::vector{0.1_r, 0.5_r}, std::vector{1e6_r, 1e9_r}, std::vector{1e9_r, 1_r}}) {
    const ContactProblem punch = reduced(s, {0.25_r}, one_piece(-1, 1, {0}), 1);
    const PunchCore<double> few = *punch_core<double>(punch);
    const PunchCore<Real50> more = *punch_core<Real50>(punch);
    CHECK(within_error(few.left, more.left));
    CHECK(within_error(few.right, more.right));
  }
}

TEST_CASE("none but flat punches have one") {
  CHECK(!punch_core<double>(reduced({0}, {}, one_piece(-1, 1, {0, 0, 1}), 1)));
  CHECK(!punch_core<double>(reduced({0}, {}, Indenter(-1, {{0, Polynomial({0})}, {1, Polynomial({1})}}), 1)));
  CHECK(punch_core<double>(reduced({0}, {}, Indenter(-1, {{0, Polynomial({1})}, {1, Polynomial({1})}}), 1)));
}

TEST_CASE_TEMPLATE("the rear share and the centre of pressure are those of the closed form", R, double, Real50) {
  for (const auto& [rear, front] : {std::pair(0.1_r, 0.5_r), {0.5_r, 0.1_r}, {0_r, 2_r}, {20_r, 0.3_r}, {3_r, 3_r}}) {
    for (const Rational& c : {-0.9_r, 0.2_r, 0.75_r}) {
      if (std::same_as<R, Real50> && c != 0.2_r) continue;
      const ContactProblem punch = reduced({rear, front}, {c}, one_piece(-1, 1, {0}), 1);
      const Resultants<R> closed = closed_form<R>(punch).solution->resultants();
      const R tolerance = std::same_as<R, double> ? R(1e-12) : R(1e-40);
      CHECK(size_of(R(rear_share<R>(rear, front, (c + 1) / 2).value - closed.load_share[0].value)) < tolerance);
      const R swapped = rear_share<R>(front, rear, (c + 1) / 2).value - closed.load_share[0].value;
      CHECK((size_of(swapped) > tolerance) == (rear != front));
    }
  }
  for (unsigned n = 0; n < 4; ++n) {
    const auto layout = FrictionLayout<R>::of(random_punch(n));
    const R centre = closed_form<R>(random_punch(n)).solution->resultants().centre_of_pressure.value;
    CHECK(size_of(R(layout.moment(0) + centre)) < (std::same_as<R, double> ? R(1e-13) : R(1e-40)));
  }
}
