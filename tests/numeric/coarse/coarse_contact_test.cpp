// The coarse contact zone, compared with closed forms and with a quadrature of this test, also for very different
// scales.

#include "numeric/variational/coarse_contact.hpp"
#include "numeric/closed_form/closed_form.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"
#include "support/random_problem.hpp"

namespace {

ContactProblem frictionless(const Indenter& indenter, const Rational& load,
                            const std::optional<Rational>& load_at = std::nullopt) {
  return reduced({0}, {}, indenter, load, load_at);
}

/// int t, and int x t / int t measured from the origin.
double integral(const CoarseContact& c) {
  double sum = 0;
  for (std::size_t j = 0; j < c.traction.size(); ++j) sum += c.traction[j] * (c.cell_edges[j + 1] - c.cell_edges[j]);
  return sum;
}

double centre_of_pressure(const CoarseContact& c) {
  double moment = 0;
  for (std::size_t j = 0; j < c.traction.size(); ++j) {
    const double a = c.cell_edges[j], b = c.cell_edges[j + 1];
    moment += c.traction[j] * (b - a) * (a + b) / 2;
  }
  return moment / integral(c);
}

/// Returns the length of the cell that contains x, or of the first or last cell.
double cell_length(const CoarseContact& c, double x) {
  const auto beyond = std::upper_bound(c.cell_edges.begin() + 1, c.cell_edges.end() - 1, x);
  return *beyond - *(beyond - 1);
}

double slack(const CoarseContact& c, const ContactInterval& zone) {
  return 0.04 * (zone.right - zone.left) + 2 * cell_length(c, zone.left) + 2 * cell_length(c, zone.right);
}

void zone_is_that_of_the_closed_form(const ContactProblem& problem, bool edges) {
  const CoarseContact c = coarse_contact(problem, 48);
  const auto exact = closed_form<double>(problem).solution->contact().front();
  RC_ASSERT(c.converged);
  RC_ASSERT(c.zones.size() == 1U);
  const auto& zone = c.zones.front();
  const double origin = to_real<double>(c.origin);
  RC_ASSERT(std::abs(origin + zone.left - exact.left.x.value) <= slack(c, zone));
  RC_ASSERT(std::abs(origin + zone.right - exact.right.x.value) <= slack(c, zone));
  RC_ASSERT((zone.left_at_edge == edges && zone.right_at_edge == edges));
}

/// Returns psi/c - u/c at x up to a constant, by the midpoint rule on 64 parts of every cell.
double unlevelled_gap(const ContactProblem& problem, const CoarseContact& c, const Polynomial& profile, double x) {
  constexpr int parts = 64;
  const double origin = to_real<double>(c.origin);
  double u = 0;
  for (std::size_t j = 0; j < c.traction.size(); ++j) {
    if (c.traction[j] == 0) continue;
    const double h = (c.cell_edges[j + 1] - c.cell_edges[j]) / parts;
    for (int k = 0; k < parts; ++k) {
      const double y = c.cell_edges[j] + (k + 0.5) * h;
      const std::size_t piece = problem.friction().piece(Rational(y + origin), Side::left);
      const double s = to_real<double>(problem.coupled_friction(piece));
      // If a midpoint is x itself, the mean over its part is used.
      const double log = std::log(std::max(std::abs(x - y), h / (2 * std::numbers::e)));
      u += c.traction[j] * h * (-log / std::numbers::pi + (y < x ? s : 0));
    }
  }
  return to_real<double>(profile(Rational(x + origin)) / problem.elasticity().compliance()) - u;
}

/// The lowest gap at the centres of free cells and the spread of gaps inside the contact away from its ends, both in
/// units of the load.
struct Complementarity {
  double free, contact;
};

Complementarity complementarity(const ContactProblem& problem, const CoarseContact& c) {
  const Polynomial& profile = problem.indenter().pieces().front().profile;
  double lowest = HUGE_VAL, highest = -HUGE_VAL, lowest_free = HUGE_VAL;
  for (std::size_t j = 1; j + 1 < c.traction.size(); ++j) {
    const double gap = unlevelled_gap(problem, c, profile, (c.cell_edges[j] + c.cell_edges[j + 1]) / 2);
    if (c.traction[j] == 0) {
      lowest_free = std::min(lowest_free, gap);
    } else if (c.traction[j - 1] < 0 && c.traction[j + 1] < 0) {
      lowest = std::min(lowest, gap);
      highest = std::max(highest, gap);
    }
  }
  const double load = to_real<double>(problem.load());
  return {(lowest_free - highest) / load, (highest - lowest) / load};
}

const Polynomial parabola_profile({0, 0, 1});
const Indenter wedge = roof(-1, 1);

bool is_zone(const ContactInterval& zone, double centre, double half, double tolerance) {
  const auto near = [&](double a, double b) { return a == doctest::Approx(b).epsilon(tolerance); };
  return near(zone.left, centre - half) && near(zone.right, centre + half);
}

}  // namespace

TEST_CASE("contact zones of parabolas are those of the closed form") {
  CHECK(rc::check([] { zone_is_that_of_the_closed_form(*parabola(4), false); }));
}

TEST_CASE("the load's growth from zero leads to the same contact as the active sets") {
  CHECK(rc::check([] {
    const ContactProblem problem = *flat_punch(3);
    const Indenter& punch = problem.indenter();
    const Rational middle = (punch.left() + punch.right()) / 2;
    const Indenter round(punch.left(), {{punch.right(), Polynomial({middle * middle, -2 * middle, 1})}});
    const ContactProblem rounded = problem.with_indenter(round);
    const coarse::Mesh mesh(rounded, middle, 24);
    for (const coarse::Load& load : {coarse::Load{to_real<double>(problem.load()), std::nullopt},
                                     coarse::Load{to_real<double>(problem.load()), mesh.edges().back() / 5}}) {
      const std::vector<char> reached = coarse::load_path(mesh, load);
      RC_ASSERT(!reached.empty());
      RC_ASSERT(coarse::with_contact_on(mesh, load, reached).violation < 1e-6);
    }
  }));
}

TEST_CASE("flat punches are in full contact") {
  CHECK(rc::check([] { zone_is_that_of_the_closed_form(*flat_punch(6), true); }));
}

TEST_CASE("a contact a millionth as wide as the support") {
  const CoarseContact c = coarse_contact(frictionless(Indenter(-1000000, {{1000000, parabola_profile}}), 1), 48);
  REQUIRE(c.zones.size() == 1);
  // a^2 = 2 P R/pi, 1/R = 2.
  const double a = std::sqrt(1 / std::numbers::pi);
  CHECK(is_zone(c.zones[0], 0, a, 0.01));
  CHECK(c.traction.size() < 400);
  CHECK(integral(c) == doctest::Approx(-1));
}

TEST_CASE("the contact of a wedge grows with the load") {
  for (const Rational& load : {1e-6_r, 1e-4_r, 1e-2_r, 1_r, 10_r, 1e3_r}) {
    const CoarseContact c = coarse_contact(frictionless(wedge, load), 48);
    CAPTURE(to_string(load));
    REQUIRE(c.converged);
    REQUIRE(c.zones.size() == 1);
    // P = int_{-a}^a |x|/sqrt(a^2 - x^2) dx = 2 a.
    if (load <= 1) CHECK(is_zone(c.zones[0], 0, to_real<double>(load) / 2, 0.02));
    CHECK(c.zones[0].left_at_edge == (load > 1));
    CHECK(c.zones[0].right_at_edge == (load > 1));
  }
}

TEST_CASE("two bumps: two zones under a small load, one under a large load") {
  const Polynomial bump({-0.25_r, 0, 1});
  const Indenter indenter(-1, {{1, bump * bump}});
  const CoarseContact light = coarse_contact(frictionless(indenter, 0.02_r), 48);
  REQUIRE(light.zones.size() == 2);
  CHECK(light.zones[0].left < -0.5);
  CHECK(light.zones[0].right > -0.5);
  CHECK(light.zones[1].left == doctest::Approx(-light.zones[0].right));
  CHECK(light.zones[1].right == doctest::Approx(-light.zones[0].left));
  CHECK(coarse_contact(frictionless(indenter, 0.5_r), 48).zones.size() == 1);
}

TEST_CASE("a step: the face that protrudes carries a small load alone, up to its edge") {
  const Indenter indenter(-1, {{0, Polynomial()}, {1, Polynomial({0.1_r})}});
  const CoarseContact light = coarse_contact(frictionless(indenter, 0.01_r), 48);
  REQUIRE(light.zones.size() == 1);
  CHECK(light.zones[0].left_at_edge);
  CHECK(light.zones[0].right_at_edge);
  CHECK(light.zones[0].right == 0);
  const CoarseContact heavy = coarse_contact(frictionless(indenter, 1), 48);
  REQUIRE(heavy.zones.size() == 2);
  CHECK(heavy.zones[0].right_at_edge);
  CHECK_FALSE(heavy.zones[1].left_at_edge);
  CHECK(heavy.zones[1].left > 0);
  CHECK(heavy.zones[1].right_at_edge);
}

TEST_CASE("an indenter that may tilt turns until its pressure is centred at the load") {
  const Indenter indenter(-3, {{3, parabola_profile}});
  const CoarseContact c = coarse_contact(frictionless(indenter, 1, 0.5_r), 48);
  REQUIRE(c.zones.size() == 1);
  CHECK(c.converged);
  CHECK(centre_of_pressure(c) == doctest::Approx(0.5).epsilon(1e-9));
  // x^2 + tilt x is the same parabola with the vertex -tilt/2.
  CHECK(c.tilt == doctest::Approx(-1).epsilon(0.01));
  const double a = std::sqrt(1 / std::numbers::pi);
  CHECK(is_zone(c.zones[0], 0.5, a, 0.02));
}

TEST_CASE("strong friction: all of the load next to one edge, and still full contact") {
  for (const int s : {15, 40}) {
    const ContactProblem problem(Elasticity::reduced(0.5_r), FrictionProfile({2 * s, 0, 2 * s}, {-1, 1}),
                                 Indenter(-2, {{2, Polynomial()}}), 1, Sliding::minus_x);
    const CoarseContact c = coarse_contact(problem, 48);
    CHECK(c.converged);
    CHECK(c.zones.size() == 1);
    CHECK(integral(c) == doctest::Approx(-1));
  }
}

TEST_CASE("a support far from 0 is like one at 0") {
  const Rational far = 1e12_r;
  const Indenter here(-2, {{2, parabola_profile}});
  const Indenter there(far - 2, {{far + 2, Polynomial({far * far, -2 * far, 1})}});
  const CoarseContact a = coarse_contact(frictionless(here, 1), 48);
  const CoarseContact b = coarse_contact(frictionless(there, 1), 48);
  CHECK(b.origin == far);
  CHECK(a.cell_edges == b.cell_edges);
  CHECK(a.traction == b.traction);
}

TEST_CASE("gap and traction by an independent quadrature") {
  for (const int s : {0, 1, 3}) {
    CAPTURE(s);
    const ContactProblem problem(Elasticity::reduced(0.5_r),
                                 FrictionProfile({Rational(s, 2), 2 * s, s}, {-0.1_r, 0.2_r}),
                                 Indenter(-2, {{2, Polynomial({0, Rational(1, 3), 1, 0, 0.5_r})}}), 1);
    CoarseContact c = coarse_contact(problem, 96);
    CHECK(c.converged);
    CHECK(*std::max_element(c.traction.begin(), c.traction.end()) <= 0);
    const Complementarity found = complementarity(problem, c);
    CHECK(found.free > -0.01);
    CHECK(found.contact < 0.02);
    // Control: the reversed traction does not fit.
    std::reverse(c.traction.begin(), c.traction.end());
    const Complementarity wrong = complementarity(problem, c);
    CHECK((wrong.contact > 0.1 || wrong.free < -0.1));
  }
}
