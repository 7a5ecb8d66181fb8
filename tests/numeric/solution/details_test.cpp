// Integrals of the traction at a place, compared with independent computations: derivatives of u and T at 50 digits,
// the closed form against the Riemann-Hilbert method, the limits at singular points against places next to them, and
// cells.

#include "numeric/interior/interior_stress_problems.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "support/problems.hpp"

namespace {

using Solution = std::shared_ptr<const ContactSolution<Real50>>;

const Real50 step("1e-12");

Rational near(const Rational& x, int times) { return x + times * parse_rational("1e-12"); }

struct Derivatives {
  Real50 displacement, load;
};

/// Derivatives from four places around x; the error is like step^4.
Derivatives derivatives(const ContactSolution<Real50>& solution, const Rational& x) {
  Derivatives result{0, 0};
  for (const auto& [times, weight] : {std::pair(-2, 1), {-1, -8}, {1, 8}, {2, -1}}) {
    const DetailedSample<Real50> there = solution.details_at(near(x, times));
    result.displacement += weight * there.displacement.value / (12 * step);
    result.load += weight * there.cumulative_load.value / (12 * step);
  }
  return result;
}

/// Places in the contact, in gaps and beyond, not at singular points.
std::vector<Rational> regular_places(const ContactProblem& problem, const ContactSolution<Real50>& solution) {
  const Rational left = problem.indenter().left(), length = problem.indenter().right() - left;
  std::vector<Rational> result;
  for (const char* part : {"-1.1", "0.0123", "1.013"}) {
    result.push_back(left + parse_rational(part) * length);
  }
  for (const auto& component : solution.contact()) {
    const Rational from(static_cast<double>(component.left.x.value));
    const Rational width(static_cast<double>(component.width.value));
    for (const char* part : {"0.31", "0.97"}) result.push_back(from + parse_rational(part) * width);
  }
  return result;
}

bool is_near(const Real50& a, const Real50& b, const Real50& allowed) { return abs(a - b) <= allowed; }

void derivatives_agree(const ContactProblem& problem, const ContactSolution<Real50>& solution) {
  const auto u = [&](const Rational& x) { return solution.details_at(x).displacement.value; };
  const auto load = [&](const Rational& x) { return solution.details_at(x).cumulative_load.value; };
  const Real50 allowed("1e-30");
  for (const Rational& x : regular_places(problem, solution)) {
    CAPTURE(to_string(x));
    const DetailedSample<Real50> there = solution.details_at(x);
    const Real50 slope = there.slope.left.value, t = there.traction.left.value;
    const auto [of_u, of_load] = derivatives(solution, x);
    CHECK(is_near(of_u, slope, allowed * (1 + abs(slope))));
    CHECK(is_near(of_load, -t, allowed * (1 + abs(t))));
  }
  CHECK(u(problem.origin_of_displacement()) == 0);
  const auto contact = solution.contact();
  const Real50 whole = to_real<Real50>(problem.load());
  Real50 sum = 0;
  const std::vector<Estimate<Real50>> loads = solution.resultants().component_load;
  REQUIRE(loads.size() == contact.size());
  for (std::size_t k = 0; k < contact.size(); ++k) {
    const Rational before(static_cast<double>(contact[k].left.x.value) - 1e-9);
    CHECK(is_near(load(before), sum, Real50("1e-40")));
    sum += loads[k].value;
  }
  CHECK(is_near(sum, whole, whole * Real50("1e-40")));
  CHECK(is_near(load(problem.indenter().right() + 1), whole, whole * Real50("1e-40")));
  CHECK(load(problem.indenter().left() - 1) == 0);
}

/// Compares the limits from both sides of a singular point with places 1e-20 beside it.
void limits_agree(const ContactSolution<Real50>& solution) {
  for (const auto& point : solution.singular_points()) {
    if (point.kind == SingularKind::free) continue;
    const Rational x(point.x.value);
    const TwoSided<Real50> limits = solution.details_at(x).shear_slope;
    for (const Side side : {Side::left, Side::right}) {
      const Rational d = parse_rational(side == Side::left ? "-1e-20" : "1e-20");
      const Real50 limit = (side == Side::left ? limits.left : limits.right).value;
      const Real50 beside = solution.details_at(x + d).shear_slope.left.value;
      const Real50 further = solution.details_at(x + 1000 * d).shear_slope.left.value;
      CAPTURE(to_string(x));
      CAPTURE(static_cast<double>(limit));
      CAPTURE(static_cast<double>(beside));
      if (isinf(limit)) {
        CHECK((limit > 0) == (beside > further));
        CHECK(abs(beside - further) > Real50("1e-4"));
      } else {
        CHECK(abs(beside - limit) <= abs(further - limit) + Real50("1e-30"));
        CHECK(abs(beside - limit) < Real50("0.05"));
      }
    }
  }
}

/// Checks p ~ K (2 pi d)^lambda on the sides with contact.
void stress_intensities_are_limits(const ContactSolution<Real50>& solution) {
  for (const auto& point : solution.singular_points()) {
    const auto& [left, right] = point.stress_intensity;
    CHECK((left || right) == point.exponent.has_value());
    if (!point.exponent || point.kind == SingularKind::free || point.constant.value != 0) continue;
    for (const auto& [k, d] : {std::pair(left, "-1e-22"), {right, "1e-22"}}) {
      if (!k) continue;
      const Real50 t = solution.at(Rational(point.x.value) + parse_rational(d)).traction.left.value;
      const Real50 power = pow(2 * pi<Real50>() * Real50("1e-22"), to_real<Real50>(*point.exponent));
      CHECK(abs(-t / power / k->value - 1) < Real50("1e-3"));
    }
  }
}

ContactProblem coated_punch(Sliding sliding) {
  return {stress_test::body(), FrictionProfile({0.5_r, 2, 1}, {1.5_r, 2}), Indenter(1, {{3, Polynomial({0.25_r})}}), 2,
          sliding};
}

}  // namespace

TEST_CASE("u' and T' are the slope and the pressure") {
  const ContactProblem wells = on_two_coatings(two_wells(), 0.5_r);
  const Solution parabola = closed_form<Real50>(stress_test::parabola()).solution;
  derivatives_agree(stress_test::parabola(), *parabola);
  const Solution zones = riemann_hilbert<Real50>(wells).solution;
  REQUIRE(zones->failed_condition() == "");
  derivatives_agree(wells, *zones);
  // Control: the solution of another problem does not fit.
  CHECK_FALSE(is_near(derivatives(*parabola, 0.1_r).displacement, zones->at(0.1_r).slope.left.value, Real50("1e-3")));
}

TEST_CASE("limits at singular points") {
  const Solution solution = closed_form<Real50>(coated_punch(Sliding::plus_x)).solution;
  stress_intensities_are_limits(*solution);
  limits_agree(*solution);
}

TEST_CASE("slow: u' and T', limits, sliding both ways, with wedges, steps and tilt" * doctest::skip()) {
  // The jump at a place that 50 digits give back exactly.
  const ContactProblem tilting = reduced({0.3_r, 1}, {0.125_r}, one_piece(-1, 1, {0}), 1, 0.2_r);
  const ContactProblem stepped =
      reduced({0.3_r}, {}, Indenter(-1, {{0, Polynomial({0})}, {1, Polynomial({0.125_r})}}), 0.1_r);
  for (const ContactProblem& p : {coated_punch(Sliding::minus_x), stress_test::jumps(Sliding::minus_x),
                                  stress_test::corners(), tilting, stepped}) {
    const Solution solution = riemann_hilbert<Real50>(p).solution;
    REQUIRE(solution->failed_condition() == "");
    derivatives_agree(p, *solution);
    stress_intensities_are_limits(*solution);
    limits_agree(*solution);
  }
}

TEST_CASE("the closed form and the Riemann-Hilbert method agree in every detail") {
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    const ContactProblem p = coated_punch(sliding);
    const auto a = closed_form<double>(p).solution, b = riemann_hilbert<double>(p).solution;
    const auto close_to = [](const Estimate<double>& x, const Estimate<double>& y) {
      return x.value == y.value || std::abs(x.value - y.value) <= 1e-11 * (1 + std::abs(x.value));
    };
    for (const char* x : {"-1", "1", "1.2", "1.5", "1.9", "2", "2.7", "3", "3.5"}) {
      CAPTURE(x);
      const auto at = a->details_at(parse_rational(x)), bt = b->details_at(parse_rational(x));
      CHECK(close_to(at.displacement, bt.displacement));
      CHECK(close_to(at.cumulative_load, bt.cumulative_load));
      CHECK(close_to(at.shear_slope.left, bt.shear_slope.left));
      CHECK(close_to(at.shear_slope.right, bt.shear_slope.right));
      CHECK(at.friction.has_value() == bt.friction.has_value());
      if (at.friction) CHECK((at.friction->left == bt.friction->left && at.friction->right == bt.friction->right));
    }
    CHECK(a->detailed_samples(7).size() == a->samples(7).size());
    CHECK(b->detailed_samples(7).size() == b->samples(7).size());
  }
}

TEST_CASE("cells know u, T and the shear's slope as well as they know the traction") {
  const ContactProblem p = stress_test::jumps();
  const auto exact = riemann_hilbert<double>(p).solution;
  const auto cells = variational_inequality(p, {.cells = 4096}).solution;
  for (const char* x : {"-3", "-1.5", "-0.4", "-0.1", "0.1", "0.5", "1.5", "2.5"}) {
    CAPTURE(x);
    const auto a = exact->details_at(parse_rational(x)), b = cells->details_at(parse_rational(x));
    CHECK(std::abs(a.displacement.value - b.displacement.value) < 1e-4);
    CHECK(std::abs(a.cumulative_load.value - b.cumulative_load.value) <= 3 * b.cumulative_load.error + 1e-4);
    CHECK(std::abs(a.shear_slope.left.value - b.shear_slope.left.value) <= 3 * b.shear_slope.left.error + 2e-3);
  }
  CHECK(cells->contact()[0].width.value == doctest::Approx(exact->contact()[0].width.value).epsilon(2e-3));
}
