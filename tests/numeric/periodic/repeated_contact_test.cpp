// Zones of contact that pass the end of the period: cells and the corrected Riemann-Hilbert method against the same problem
// with its data moved, and against the closed form.

#include "numeric/periodic/repeated_contact.hpp"

#include "numeric/bodies/body_contact.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "periodic_problems.hpp"

using namespace numeric;

namespace {

using Solved = std::shared_ptr<const ContactSolution<double>>;

Solved solved(const Attempt<double>& found) {
  INFO(found.reason);
  REQUIRE(found.solution);
  REQUIRE(found.solution->failed_condition().empty());
  return found.solution;
}
Solved on_cells(const ContactProblem& problem) { return solved(variational_inequality(problem, {.cells = 1024})); }

/// A wave on [-1, 1].
ContactProblem wave(int n, const Rational& cosine, const Rational& load,
                    std::vector<Rational> s = {0.1_r, 0.5_r, 0.2_r},
                    const std::vector<Rational>& jumps = {-0.25_r, 0.25_r}) {
  return periodic(2, std::move(s), jumps, flat(-1, 1), load)
      .with_indenter(flat(-1, 1).with_harmonics({{n, cosine, 0}}));
}

/// The distance of two places on a circle of the length 2.
double apart(const Estimate<double>& a, const Estimate<double>& b) {
  return std::abs(std::remainder(a.value - b.value, 2));
}

/// Checks that `b` is the solution `a` moved by `shift` along a period 2. `x` are regular places.
void check_moved(const ContactSolution<double>& a, const ContactSolution<double>& b, const Rational& shift,
                 std::size_t zones, const std::vector<Rational>& x) {
  const double error = a.equal_cells() ? 1e-9 : 1e-11;
  const auto moved = [&](Estimate<double> place) { return place + Estimate<double>{to_real<double>(shift)}; };
  const auto in_a = a.contact(), in_b = b.contact();
  REQUIRE(in_a.size() == zones);
  REQUIRE(in_b.size() == zones);
  for (const auto& zone : in_a) {
    const auto same = [&](const auto& other) {
      return apart(moved(zone.left.x), other.left.x) < error && apart(moved(zone.right.x), other.right.x) < error &&
             zone.left.kind == other.left.kind && zone.right.kind == other.right.kind;
    };
    CHECK(std::count_if(in_b.begin(), in_b.end(), same) == 1);
    CHECK(zone.left.kind == SingularKind::free);
  }
  CHECK(a.singular_points().size() == b.singular_points().size());
  CHECK(std::abs(a.resultants().effective_friction.value - b.resultants().effective_friction.value) < error);
  CHECK(apart(moved(a.resultants().centre_of_pressure), b.resultants().centre_of_pressure) < error);
  const DetailedSample<double> first_a = a.details_at(x.front()), first_b = b.details_at(x.front() + shift);
  const double load = a.resultants().normal.value;
  for (const Rational& place : x) {
    CAPTURE(place);
    const DetailedSample<double> here = a.details_at(place), there = b.details_at(place + shift);
    CHECK(there.x == to_real<double>(place + shift));
    CHECK(std::abs(here.traction.left.value - there.traction.left.value) < 100 * error);
    CHECK(std::abs(here.slope.left.value - there.slope.left.value) < 100 * error);
    CHECK(std::abs(here.gap->value - there.gap->value) < error);
    CHECK(std::abs(here.displacement.value - first_a.displacement.value - there.displacement.value +
                   first_b.displacement.value) < error);
    CHECK(std::abs(std::remainder(here.cumulative_load.value - first_a.cumulative_load.value -
                                      there.cumulative_load.value + first_b.cumulative_load.value,
                                  load)) < error);
    const DetailedSample<double> next = a.details_at(place + 2);
    CHECK(next.traction.left.value == here.traction.left.value);
    CHECK(next.cumulative_load.value == here.cumulative_load.value);
  }
}

}  // namespace

TEST_CASE("two zones, one of them across the end of the period: the data moved by half a period") {
  const ContactProblem here = wave(2, -0.01_r, 0.02_r);
  const ContactProblem there = wave(2, -0.01_r, 0.02_r, {0.5_r, 0.2_r, 0.1_r, 0.5_r}, {-0.75_r, 0, 0.75_r});
  for (const auto& solve : {+[](const ContactProblem& p) { return on_cells(p); },
                            +[](const ContactProblem& p) { return solved(contact_on_body(p)); }}) {
    const Solved a = solve(here), b = solve(there);
    check_moved(*a, *b, 1, 2, {-0.97_r, -0.5_r, -0.2_r, 0.03_r, 0.6_r, 0.95_r});
    const std::vector<Estimate<double>> p = a->resultants().load_share, q = b->resultants().load_share;
    REQUIRE(p.size() == 3);
    REQUIRE(q.size() == 4);
    CHECK(std::abs(p[0].value - q[2].value) < 1e-9);
    CHECK(std::abs(p[1].value - q[0].value - q[3].value) < 1e-9);
    CHECK(std::abs(p[2].value - q[1].value) < 1e-9);
    CHECK(std::abs(a->details_at(-1).cumulative_load.value) < 1e-12);
    CHECK(a->details_at(-1).displacement.value - a->details_at(1).displacement.value == 0);
    CHECK(std::abs(a->details_at(0).displacement.value) < 1e-12);
    std::vector<double> normal(2), shear(2);
    a->tractions(std::vector<double>{0.95, 2.95}, normal, shear);
    CHECK(normal[0] == doctest::Approx(a->at(0.95_r).traction.left.value).epsilon(1e-9));
    CHECK(normal[1] == doctest::Approx(normal[0]).epsilon(1e-9));
    CHECK(shear[0] == doctest::Approx(to_real<double>(here.shear_ratio(2)) * normal[0]));
  }
}

TEST_CASE("one zone across the end of the period: cells and the closed form") {
  const ContactProblem problem = wave(1, 0.01_r, 0.02_r);
  const Solved cells = on_cells(problem), formula = solved(closed_form<double>(problem));
  const auto a = cells->contact(), b = formula->contact();
  REQUIRE(a.size() == 1);
  CHECK(a[0].left.kind == SingularKind::free);
  CHECK(std::abs(a[0].left.x.value - b[0].left.x.value) <= a[0].left.x.error);
  CHECK(std::abs(a[0].right.x.value - b[0].right.x.value) <= a[0].right.x.error);
  CHECK(cells->singular_points().size() == formula->singular_points().size());
  CHECK(std::isfinite(cells->largest_pressure().value.value));
  const Resultants<double> p = cells->resultants(), q = formula->resultants();
  CHECK(std::abs(p.centre_of_pressure.value - q.centre_of_pressure.value) <= p.centre_of_pressure.error);
  REQUIRE(p.load_share.size() == 3);
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(std::abs(p.load_share[k].value - q.load_share[k].value) <= p.load_share[k].error);
  for (const Rational& x : {-0.9_r, -0.6_r, 0.3_r, 0.8_r, 2.2_r}) {
    CAPTURE(x);
    const DetailedSample<double> c = cells->details_at(x), f = formula->details_at(x);
    CHECK(std::abs(c.traction.left.value - f.traction.left.value) <= 2 * c.traction.left.error);
    CHECK(std::abs(c.displacement.value - f.displacement.value) <= c.displacement.error + 1e-6);
    CHECK(std::abs(c.cumulative_load.value - f.cumulative_load.value) <= c.cumulative_load.error + 1e-6);
    CHECK(c.friction->left == f.friction->left);
  }
  CHECK(std::abs(formula->details_at(-1).cumulative_load.value) < 1e-15);
}

TEST_CASE("pieces as long as the period, in contact where they meet: the same pieces with another beginning") {
  const Polynomial bowl({0.1_r, -0.2_r, 0.1_r}), steeper({0.12_r, 0.22_r, 0.1_r});  // (1-x)^2/10, (1+x)^2/10 + (1+x)/50
  const ContactProblem here = periodic(2, {0.2_r, 0.6_r}, {0.1_r}, Indenter(-1, {{0, steeper}, {1, bowl}}), 0.02_r);
  const ContactProblem there =
      periodic(2, {0.2_r, 0.6_r, 0.2_r}, {0.1_r, 1}, Indenter(0, {{1, bowl}, {2, steeper.composed(1, -2)}}), 0.02_r);
  CHECK(beginning_at(0, here) == there);
  CHECK(beginning_at(-2, here) == there.moved(1, -2));
  const Solved a = solved(contact_on_body(here)), b = solved(contact_on_body(there));
  check_moved(*a, *b, 0, 1, {-0.99_r, -0.5_r, 0.3_r, 0.98_r});
  const auto points = a->singular_points();
  REQUIRE(points.size() == 3);
  CHECK(points[1].kind == SingularKind::wedge_and_jump);
  CHECK(points[1].x.value == -1);
  check_moved(*on_cells(here), *on_cells(there), 0, 1, {-0.99_r, -0.5_r, 0.3_r, 0.98_r});
}

TEST_CASE("contact without a gap on cells has no edges; the Riemann-Hilbert method refuses it") {
  const ContactProblem problem = wave(1, -0.01_r, 2);
  const Solved cells = on_cells(problem), formula = solved(closed_form<double>(problem));
  const auto a = cells->contact(), b = formula->contact();
  REQUIRE(a.size() == 1);
  CHECK(a[0].left.kind == SingularKind::friction_jump);
  CHECK(a[0].left.x.value == -1);
  CHECK(a[0].left.exponent == b[0].left.exponent);
  CHECK(a[0].width.value == 2);
  const auto points = cells->singular_points(), expected = formula->singular_points();
  REQUIRE(points.size() == expected.size());
  for (std::size_t k = 0; k < points.size(); ++k) CHECK(points[k].exponent == expected[k].exponent);
  CHECK(cells->largest_pressure().exponent == formula->largest_pressure().exponent);
  const Resultants<double> p = cells->resultants(), q = formula->resultants();
  CHECK(std::abs(p.effective_friction.value - q.effective_friction.value) <= p.effective_friction.error);
  CHECK(std::abs(p.centre_of_pressure.value - q.centre_of_pressure.value) <= p.centre_of_pressure.error);
  CHECK(contact_on_body(problem).reason == "the repeated contact has no gap, or lengths are out of range");
  // Its ends are not in a gap by rounding: in double, 0.2 - 0.3 is not -0.1.
  const ContactProblem tenths = problem.moved(0.15_r, 0.05_r);
  CHECK(beginning_in_gap(tenths, {{-0.1, 0.2}}) == -0.1_r);
  CHECK(on_cells(tenths)->equal_cells()->left == -0.1_r);
  // A convex wedge where the pieces meet.
  const ContactProblem roof = periodic(2, {0.1_r}, {}, one_piece(-1, 1, {0, 0, -0.001_r, 0, 0.0003_r}), 2);
  CHECK(on_cells(roof)->contact()[0].left.kind == SingularKind::friction_jump);
  CHECK(std::isinf(on_cells(roof)->largest_pressure().value.value));
  CHECK(on_cells(roof)->largest_pressure().x.value == -1);
}
