// The largest von Mises stress: for Hertz's line contact, whose stresses below its middle are known; otherwise by brute
// force.

#include "numeric/interior/largest_stress.hpp"

#include <random>

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/interior/interior_stress_problems.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "numeric/variational/variational_solution.hpp"

using namespace steadyslide::numeric::stress_test;

namespace {

ContactProblem parabola_under(const FrictionProfile& friction, const Rational& poisson = 0.3_r) {
  return {Elasticity(Solid(poisson, 1)), friction, Indenter(-9, {{9, Polynomial({0, 0, 1})}}), 1};
}

/// Von Mises stress below the middle of Hertz's contact, in units of a and p_0 [Joh85, (4.46)], nu = 0.3.
Real50 von_mises_on_axis(const Real50& z) {
  using std::sqrt;
  const Real50 root = sqrt(1 + z * z);
  const Real50 xx = 2 * z - (1 + 2 * z * z) / root, zz = -1 / root, yy = Real50(3) / 10 * (xx + zz);
  return sqrt(((xx - yy) * (xx - yy) + (yy - zz) * (yy - zz) + (zz - xx) * (zz - xx)) / 2);
}

/// Compares the largest stress of Hertz's contact with the maximum of the formula on the axis.
template <Real R>
void check_hertz(const R& tolerance, const R& place) {
  using std::abs;
  // By golden section: the error of the value is the square of the error of the place.
  Real50 low = 0.5, high = 1;
  const Real50 golden = (sqrt(Real50(5)) - 1) / 2;
  while (high - low > Real50(1e-24)) {
    const Real50 one = high - golden * (high - low), two = low + golden * (high - low);
    (von_mises_on_axis(one) > von_mises_on_axis(two) ? high : low) =
        von_mises_on_axis(one) > von_mises_on_axis(two) ? two : one;
  }
  const auto solution = closed_form<R>(parabola_under(FrictionProfile({0}))).solution;
  const InteriorStress<R> interior(*solution);
  CHECK(unbounded_places(*solution).empty());
  CHECK(default_depth(*solution) == 0);
  const auto largest = largest_stress<R>(interior, 0);
  REQUIRE(largest);
  const R a = solution->contact().front().right.x.value;
  const R p0 = -solution->at(0).traction.left.value;
  CHECK(abs(largest->von_mises.value / p0 - static_cast<R>(von_mises_on_axis(low))) < tolerance);
  CHECK(abs(largest->z.value / a - static_cast<R>(low)) < place);
  CHECK(abs(largest->x.value) < place);
  CHECK(largest->z.error < 10 * place);
  // `low` itself is known to 1e-24.
  CHECK(abs(largest->z.value / a - static_cast<R>(low)) * a <= largest->z.error + a * R(1e-24));
  // Control: at a depth that differs by a hundredth of the half-width the stress differs.
  CHECK(abs(von_mises_on_axis(low * 1.05) - von_mises_on_axis(low)) > 1e-4);
}

}  // namespace

TEST_CASE("Hertz: the maximum under the middle, found by golden section at 50 digits") {
  check_hertz<double>(1e-14, 1e-7);
}

TEST_CASE("slow: Hertz: the maximum under the middle at 50 digits" * doctest::skip()) {
  check_hertz<Real50>(Real50(1e-28), Real50(1e-13));
}

TEST_CASE("no place has more: jumps, strong friction, a punch below its least depth, cells") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  const std::pair<std::shared_ptr<const ContactSolution<double>>, bool> cases[] = {
      {closed_form<double>(parabola_under(FrictionProfile({0.5_r, 0.2_r}, {0.1_r}))).solution, false},
      {closed_form<double>(parabola_under(FrictionProfile({0.8_r}))).solution, false},
      {closed_form<double>(punch()).solution, true},
      {riemann_hilbert<double>(corners()).solution, true},
      {variational_inequality(jumps(), {.cells = 256}).solution, true}};
  for (const auto& [solution, unbounded] : cases) {
    CHECK(unbounded_places(*solution).empty() != unbounded);
    const InteriorStress<double> interior(*solution);
    const double depth = default_depth(*solution);
    CHECK((depth > 0) == (unbounded || solution->singular_points().size() > 2));
    const auto largest = largest_stress<double>(interior, depth);
    REQUIRE(largest);
    CAPTURE(largest->x.value);
    CAPTURE(largest->z.value);
    const double left = solution->contact().front().left.x.value;
    const double width = solution->contact().back().right.x.value - left;
    CAPTURE(left);
    CAPTURE(width);
    double highest = 0;
    const auto points = solution->singular_points();
    for (int i = 0; i < 4000; ++i) {
      // Points are denser towards the surface; every second one lies beside a singular point, at a random scale.
      const double scale = width * std::pow(10, -8 * unit(random));
      const auto& point = points[static_cast<std::size_t>(i) % points.size()];
      const double x =
          i % 2 == 0 ? left + width * (1.4 * unit(random) - 0.2) : point.x.value + scale * (4 * unit(random) - 2);
      const double z = std::max(depth, i % 2 == 0 ? width * std::pow(10, -4 * unit(random)) : scale);
      const StressState<double> state = interior.at(Rational(x), Rational(z));
      highest = std::max(highest, state.von_mises()->value);
    }
    CHECK(highest <= largest->von_mises.value * (1 + 1e-12));
    CHECK(highest > (unbounded ? 0.5 : 0.95) * largest->von_mises.value);
  }
  // With strong friction the largest stress is at the surface.
  CHECK(largest_stress<double>(InteriorStress<double>(*cases[1].first), 0)->z.value == 0);
}

TEST_CASE("on cells: how far stresses and the place of the largest one are from those of the exact traction") {
  std::mt19937 random(32);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> too_large;
  double furthest = 0;
  for (const ContactProblem& problem : {parabola(), jumps(), jumps(Sliding::minus_x), corners(), punch(),
                                        parabola_under(FrictionProfile({0.5_r, 0.2_r}, {0.1_r}), 0.48_r)}) {
    const auto truth = riemann_hilbert<double>(problem).solution;
    const InteriorStress<double> exact(*truth);
    const double left = truth->contact().front().left.x.value;
    const double width = truth->contact().back().right.x.value - left;
    for (const std::size_t cells : {512U, 4096U}) {
      CAPTURE(cells);
      const auto found = variational_inequality(problem, {.cells = cells}).solution;
      const InteriorStress<double> interior(*found);
      const double cell = dynamic_cast<const VariationalSolution&>(*found).cell_length();
      for (int i = 0; i < 200; ++i) {
        // From the length of a cell to that of the contact.
        const Rational x(left + width * (1.4 * unit(random) - 0.2));
        const Rational z(cell * std::pow(width / cell, unit(random)));
        const Estimate<double> here = *interior.at(x, z).von_mises(), there = *exact.at(x, z).von_mises();
        const double off = std::abs(here.value - there.value);
        CAPTURE(to_string(x));
        CAPTURE(to_string(z));
        CHECK(off <= here.error);
        too_large.push_back(here.error / off);
      }
      const double depth = width / 20;
      const auto largest = largest_stress<double>(interior, depth), of_exact = largest_stress<double>(exact, depth);
      CAPTURE(largest->x.value);
      CHECK(std::abs(largest->von_mises.value - of_exact->von_mises.value) <= largest->von_mises.error);
      // If two maxima are almost equal, the other one may be the largest.
      const double there = exact.at(Rational(largest->x.value), Rational(largest->z.value)).von_mises()->value;
      CHECK(there >= of_exact->von_mises.value - 2 * largest->von_mises.error);
      if (std::abs(largest->x.value - of_exact->x.value) > 0.3 * width) continue;
      CHECK(std::abs(largest->x.value - of_exact->x.value) <= largest->x.error);
      CHECK(std::abs(largest->z.value - of_exact->z.value) <= largest->z.error);
      CHECK(largest->x.error <= (cells == 512 ? 1 : 0.8) * width);
      furthest = std::max(furthest, std::abs(largest->x.value - of_exact->x.value));
    }
  }
  CHECK(furthest > 1e-6);
  std::ranges::sort(too_large);
  const double median = too_large[too_large.size() / 2], high = too_large[too_large.size() * 95 / 100];
  CAPTURE(median);
  CAPTURE(high);
  CHECK(median < 30);
  CHECK(high < 1000);
}

TEST_CASE("without Poisson's ratio there is none") {
  const ContactProblem problem(Elasticity::reduced(0.25_r), FrictionProfile({0.2_r}), Indenter(-1, {{1, Polynomial()}}),
                               1);
  const InteriorStress<double> interior(*closed_form<double>(problem).solution);
  CHECK_FALSE(largest_stress<double>(interior, 0.1));
  CHECK_FALSE(interior.at(0, 1).gradient);
  CHECK_THROWS_AS(largest_stress<double>(interior, -1), std::invalid_argument);
}
