// Contact that changes its shape as the load grows: components merge; wedges, jumps and steps are reached; contact at a
// point.

#include "support/solved_contact.hpp"

namespace {

ContactProblem sloped_wells(const Rational& slope, const Rational& load) {
  return on_two_coatings(two_wells(slope), load);
}

std::size_t components(const ContactProblem& p) { return riemann_hilbert<double>(p).solution->contact().size(); }

}  // namespace

TEST_CASE("two components merge") {
  for (const Rational& slope : {0_r, 0.2_r}) {
    double two = 4, one = 6;
    REQUIRE(components(sloped_wells(slope, 4)) == 2U);
    REQUIRE(components(sloped_wells(slope, 6)) == 1U);
    while (one - two > 4e-15) {
      const double middle = (one + two) / 2;
      (components(sloped_wells(slope, Rational(middle))) == 2 ? two : one) = middle;
    }
    double outer = 0;
    for (const double change : {-0.1, -1e-3, -1e-6, -1e-9, -1e-12, 0., 1e-12, 1e-9, 1e-6, 1e-3, 0.1}) {
      CAPTURE(change);
      const auto found = solved<double>(sloped_wells(slope, Rational(two * (1 + change))));
      const auto zones = found->contact();
      if (std::abs(change) >= 1e-9) CHECK(zones.size() == (change < 0 ? 2U : 1U));
      // The outer ends grow with the load, independently of the zones between them.
      const double now = zones.back().right.x.value - zones.front().left.x.value;
      CHECK(now >= outer - 1e-14);
      outer = now;
      // Like a crack, the gap closes with the square root of the missing load.
      if (zones.size() == 2 && change < 0) {
        const double gap = zones[1].left.x.value - zones[0].right.x.value;
        CHECK(gap > std::sqrt(-change));
        CHECK(gap < 2 * std::sqrt(-change));
      }
    }
  }
  solved<Real50>(sloped_wells(0, 4));
}

TEST_CASE("contact does not cover a step beside a jump, however near") {
  // Two slopes with a small step at 14/25, lower on its right. Friction jumps there, or slightly beside it.
  const auto problem = [](const Rational& step, const Rational& jump) {
    const Indenter indenter(
        -1, {{0.56_r, Polynomial({-0.860781_r, -0.860781_r})}, {1, Polynomial({-1.396619128_r - step, 0.0960728_r})}});
    return reduced({0.04_r, 0.06_r}, {jump}, indenter, 0.0772279_r, std::nullopt, Sliding::minus_x);
  };
  for (const Rational& step : {2e-9_r, 4e-4_r}) {
    const auto at_step = solved<double>(problem(step, 0.56_r));
    REQUIRE(at_step->contact().size() == 2U);
    const Estimate<double> friction = at_step->resultants().effective_friction;
    for (const Rational& beside : {5e-17_r, -5e-17_r, 1e-15_r, -1e-13_r, 1e-11_r}) {
      CAPTURE(to_string(beside));
      const auto found = solved<double>(problem(step, Rational(0.56_r + beside)));
      CHECK(found->contact().size() == 2U);
      CHECK(found->resultants().effective_friction.value == doctest::Approx(friction.value).epsilon(1e-7));
    }
  }
}

TEST_CASE("contact grows across a jump and a wedge or a step in the same place") {
  const Polynomial square({0, 0, 1}), steeper({-1, 1, 1}), flatter({0, 1}), higher({0.5_r, 0, 1}),
      lower({-0.5_r, 0, 1});
  for (const Polynomial& right : {square, steeper, flatter, higher, lower}) {
    double left_end = 0;
    bool at_step = false, beyond = false;
    for (const double load : {0.1, 1., 2., 2.5, 3., 3.1, 3.2, 3.5, 4., 5., 6., 8., 12., 20.}) {
      CAPTURE(load);
      const auto found =
          solved<double>(reduced({0.3_r, 0.1_r}, {1}, Indenter(-10, {{1, square}, {10, right}}), Rational(load)));
      const auto zones = found->contact();
      // Under a larger load the contact is larger.
      CHECK(zones.front().left.x.value < left_end);
      left_end = zones.front().left.x.value;
      CHECK((zones.back().right.x.value > 1 || !beyond));
      beyond = zones.back().right.x.value > 1;
      for (const auto& zone : zones) {
        for (const auto& end : {zone.left, zone.right}) {
          if (end.kind != SingularKind::step) continue;
          at_step = true;
          CHECK(end.x.value == 1);
          CHECK(end.intensity.value > 0);
        }
      }
    }
    CHECK(beyond);
    CHECK(at_step == (right == higher || right == lower));
  }
}

TEST_CASE_TEMPLATE("full contact under edges, and both faces of a step", R, double, Real50) {
  const auto f = [](const Indenter& indenter, const Rational& load) {
    return reduced({0.3_r, 1, 0}, {-0.5_r, Rational(1, 3)}, indenter, load);
  };
  std::vector<Indenter> indenters{roof(-1, 1)};
  if (std::same_as<R, double>) {
    for (const auto& c : {std::vector<Rational>{}, {0, 0.01_r}, {0, 0, 1}}) indenters.push_back(one_piece(-1, 1, c));
  }
  for (const Indenter& indenter : indenters) {
    const auto zones = solved<R>(f(indenter, 30))->contact();
    REQUIRE(zones.size() == 1U);
    CHECK((zones[0].left.kind == SingularKind::edge && zones[0].right.kind == SingularKind::edge));
    CHECK(zones[0].right.x.value - zones[0].left.x.value == 2);
  }
  const Indenter step(-1, {{0, Polynomial()}, {1, Polynomial({0.1_r})}});
  const auto zones = solved<R>(f(step, 5))->contact();
  REQUIRE(zones.size() == 2U);
  CHECK(zones[0].right.kind == SingularKind::step);
  CHECK(zones[0].right.x.value == 0);
  CHECK(zones[1].left.kind == SingularKind::free);
  CHECK(zones[1].left.x.value > 0);
  CHECK(zones[1].right.kind == SingularKind::edge);
}

TEST_CASE_TEMPLATE("contact in a point: widths scale with the load as they must", R, double, Real50) {
  // Near the vertex psi ~ |x|^n, so the width ~ P^(1/n).
  struct Case {
    Indenter indenter;
    int power;
    std::vector<Rational> jumps;
  };
  const Case cases[] = {{one_piece(-100, 100, {0, 0, 1}), 2, {0}},
                        {one_piece(-1, 1, {Rational(1, 9), Rational(-2, 3), 1}), 2, {}},
                        {one_piece(-1, 1, {0, 0, 0, 0, 1}), 4, {0}},
                        {Indenter(-1, {{0, Polynomial({0, -1, 1})}, {1, Polynomial({0, 1})}}), 1, {0}}};
  for (const Case& c : cases) {
    if (!std::same_as<R, double> && c.power != 1) continue;
    std::vector<Rational> s{0.3_r};
    if (!c.jumps.empty()) s.push_back(1);
    const auto scaled_width = [&](const char* load) {
      using std::pow;
      const Rational P = parse_rational(load);
      const auto found = solved<R>(reduced(s, c.jumps, c.indenter, P));
      REQUIRE(found->contact().size() == 1U);
      return R(found->state().set.span_length() * to_real<R>(found->problem().frame().unit) /
               pow(to_real<R>(P), R(1) / c.power));
    };
    // The effect of the profile's next term is as small as the contact.
    const R limit = scaled_width("1e-30");
    using std::abs;
    CHECK(abs(scaled_width("1e-12") / limit - 1) < 1e-11);
    CHECK(abs(scaled_width("1e-27") / limit - 1) < (std::same_as<R, double> ? R(1e-13) : R(1e-26)));
  }
}
