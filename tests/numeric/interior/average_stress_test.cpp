// Stresses averaged along x: compared with quadrature of the stresses at points, with loads at the surface, and between
// methods and meshes. The largest one is compared with random windows.

#include "numeric/interior/average_stress.hpp"

#include <random>

#include "numeric/interior/interior_stress_problems.hpp"
#include "numeric/interior/largest_stress.hpp"
#include "numeric/variational/variational_inequality.hpp"

using namespace steadyslide::numeric::stress_test;

namespace {

const std::vector<ContactProblem> averaged_problems{jumps(), jumps(Sliding::minus_x), corners(),
                                                    punch(Sliding::minus_x)};

template <Real R>
StressState<R> average_at(const AverageStress<R>& average, const R& x, const R& z) {
  StressState<R> state;
  average.at(std::span(&x, 1), std::span(&z, 1), std::span(&state, 1));
  return state;
}

/// Compares averages on cells with those of the exact traction, at every depth.
void check_on_cells(std::size_t cells, double largest_error) {
  std::mt19937 random(36);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> too_large;
  for (const ContactProblem& problem : averaged_problems) {
    const Solved<double> solved(problem);
    for (const double length : {0.02, 0.3}) {
      const AverageStress<double> exact(solved.solution.piecewise_traction(), length);
      const auto largest_exact = largest_stress<double>(exact, 0);
      const auto found = variational_inequality(problem, {.cells = cells}).solution;
      const AverageStress<double> on_cells(found->piecewise_traction(), length);
      for (int i = 0; i < 50; ++i) {
        const double x = solved.left + solved.length * (1.4 * unit(random) - 0.2);
        const double z = i % 5 == 0 ? 0 : solved.length * std::pow(10, -4 * unit(random));
        CAPTURE(x);
        CAPTURE(z);
        const Estimate<double> here = *average_at(on_cells, x, z).von_mises();
        const double off = std::abs(here.value - average_at(exact, x, z).von_mises()->value);
        CHECK(off <= here.error);
        too_large.push_back(here.error / off);
      }
      // The largest average is at a window that ends at a singular point.
      const Estimate<double> here = average_at(on_cells, largest_exact->x.value, 0.0).xx;
      CHECK(std::abs(here.value - average_at(exact, largest_exact->x.value, 0.0).xx.value) <= here.error);
      const auto largest = largest_stress<double>(on_cells, 0);
      CHECK(std::abs(largest->von_mises.value - largest_exact->von_mises.value) <=
            largest->von_mises.error + largest_exact->von_mises.error);
      CHECK(largest->von_mises.error <= largest_error * largest->von_mises.value);
    }
  }
  std::ranges::sort(too_large);
  const double median = too_large[too_large.size() / 2], high = too_large[too_large.size() * 95 / 100];
  CAPTURE(median);
  CAPTURE(high);
  CHECK(median < 30);
  CHECK(high < 1000);
}

}  // namespace

TEST_CASE_TEMPLATE("the mean of the stresses at points of the window, by Gauss's rule", R, double, Real50) {
  const R length = R(0.25), tolerance = std::is_same_v<R, double> ? R(1e-12) : R(1e-30);
  JacobiRules<R> rules;
  const UnitRule<R>& rule = rules.get({}, {}, std::is_same_v<R, double> ? 24 : 60);
  for (const ContactProblem& problem : averaged_problems) {
    const Solved<R> solved(problem);
    const AverageStress<R> average(solved.solution.piecewise_traction(), length);
    for (const double fraction : {-0.2, 0.3, 0.9, 2.0}) {
      CAPTURE(fraction);
      const R x = to_real<R>(solved.place(fraction)), z = R(0.375);
      std::vector<R> sums(9);
      for (std::size_t i = 0; i < rule.size(); ++i) {
        const R there = x - length / 2 + length * rule.from_left[i];
        StressState<R> state;
        solved.interior.at(std::span(&there, 1), std::span(&z, 1), std::span(&state, 1));
        const std::vector<Estimate<R>> values = numbers(state);
        for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += rule.weights[i] * values[k].value;
      }
      const std::vector<Estimate<R>> found = numbers(average_at(average, x, z));
      for (const std::size_t k : {0U, 1U, 2U, 3U, 7U, 8U}) {  // the invariants are not linear
        CAPTURE(k);
        CHECK(size_of(R(found[k].value - sums[k])) < tolerance * (1 + size_of(sums[0])));
      }
    }
    CHECK_THROWS_AS(AverageStress<R>(solved.solution.piecewise_traction(), R(0)), std::invalid_argument);
  }
}

TEST_CASE("at the surface: the loads in the window, and the slopes of the displacement") {
  const double length = 0.125;
  for (const ContactProblem& problem : averaged_problems) {
    const Solved<double> solved(problem);
    const AverageStress<double> average(solved.solution.piecewise_traction(), length);
    for (const double fraction : {-0.1, 0.001, 0.4, 0.77, 1.3}) {
      CAPTURE(fraction);
      const Rational x(to_real<double>(solved.place(fraction)));
      const auto begin = solved.solution.details_at(x - Rational(length / 2)),
                 end = solved.solution.details_at(x + Rational(length / 2));
      const StressState<double> state = average_at(average, to_real<double>(x), 0.0);
      const double load = end.cumulative_load.value - begin.cumulative_load.value;
      CHECK(std::abs(state.zz.value + load / length) < 1e-11);
      const double rise = end.displacement.value - begin.displacement.value;
      CHECK(std::abs(state.gradient->z_x.value + rise / length) < 1e-10);
      CHECK(state.zz.error < 1e-9);
      // Control: the load of a window that is moved by a thousandth of its length.
      if (load == 0) continue;
      const StressState<double> moved = average_at(average, to_real<double>(x) + length / 1000, 0.0);
      CHECK(std::abs(moved.zz.value + load / length) > 1e-8);
    }
  }
}

TEST_CASE("on cells: how far averages are from those of the exact traction, at every depth") {
  check_on_cells(1000, 2);
}

TEST_CASE("slow: on cells: how far averages are from those of the exact traction, 8192 cells" * doctest::skip()) {
  check_on_cells(8192, 0.6);
}

TEST_CASE("no window has a larger average than the largest one; it is finite where the stress is not") {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const ContactProblem& problem : averaged_problems) {
    const Solved<double> solved(problem);
    REQUIRE_FALSE(unbounded_places(solved.solution).empty());
    for (const double length : {0.001, 0.1, 5.0}) {
      const AverageStress<double> average(solved.solution.piecewise_traction(), length);
      const auto largest = largest_stress<double>(average, 0);
      CAPTURE(length);
      CAPTURE(largest->x.value);
      CAPTURE(largest->z.value);
      CHECK(largest->von_mises.error < 1e-8 * largest->von_mises.value);
      double highest = 0;
      const auto points = solved.solution.singular_points();
      for (int i = 0; i < 400; ++i) {
        const auto& point = points[static_cast<std::size_t>(i) % points.size()];
        const double scale = std::max(length, solved.length) * std::pow(10, -6 * unit(random));
        const double x = point.x.value + (i % 3 - 1) * length / 2 + scale * (2 * unit(random) - 1);
        const double z = i % 4 == 0 ? 0 : scale * unit(random);
        highest = std::max(highest, average_at(average, x, z).von_mises()->value);
      }
      CHECK(highest <= largest->von_mises.value * (1 + 1e-9));
      CHECK(highest >= 0.9 * largest->von_mises.value);
    }
  }
}
