// Stresses below periodic contact: sums over many periods, the surface, far below, and cells.

#include "numeric/interior/interior_stress.hpp"
#include "numeric/interior/surface_stress.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "periodic_problems.hpp"

namespace {

using namespace numeric;
using Part = Estimate<double> StressState<double>::*;
const std::array<Part, 3> stress_parts{&StressState<double>::xx, &StressState<double>::zz, &StressState<double>::xz};

/// With a gap, and in full contact.
std::vector<ContactProblem> periodic_contacts() {
  const Indenter wave = flat(-0.5_r, 0.5_r).with_harmonics({{1, -0.05_r, 0.01_r}});
  std::vector<ContactProblem> result;
  for (const Rational& load : {0.05_r, 0.6_r}) {
    const FrictionProfile friction({0.3_r, 0.9_r, 0.3_r}, {-0.1_r, 0.02_r});
    result.push_back(
        ContactProblem(Elasticity(Solid(0.3_r, 1_r)), friction, flat(-0.5_r, 0.5_r), load, Sliding::minus_x)
            .with_body(Body::periodic(1))
            .with_indenter(wave));
  }
  return result;
}

}  // namespace

TEST_CASE("periodic stresses are sums over many periods, with the constant that stops the stretching") {
  for (const ContactProblem& problem : periodic_contacts()) {
    const auto solution = closed_form<double>(problem).solution;
    REQUIRE(solution);
    const InteriorStress<double> stress(problem, *solution), of_one(*solution);
    const double constant = 2 * to_real<double>(problem.elasticity().gamma() * problem.load());
    for (const auto& [x, z] : {std::pair(0.3_r, 0.01_r), {-0.45_r, 0.4_r}, {0.05_r, 2_r}}) {
      const StressState<double> found = stress.at(x, z), moved = stress.at(x + 7, z);
      for (const Part part : stress_parts) {
        // The rest of the sum over -n, ..., n decreases like 1/n.
        const auto sum = [&, &x = x, &z = z](int n) {
          double total = part == &StressState<double>::xx ? constant : 0;
          for (int j = -n; j <= n; ++j) total += (of_one.at(x + j, z).*part).value;
          return total;
        };
        const double coarse = sum(150), fine = sum(300);
        CHECK(std::abs(2 * fine - coarse - (found.*part).value) < 2e-4 * std::abs(constant));
        CHECK(std::abs((found.*part).value - (moved.*part).value) < 1e-12);
        CHECK((found.*part).error < 1e-10);
      }
    }
    const StressState<double> deep = stress.at(0.1_r, 5);
    const double load = to_real<double>(problem.load());
    CHECK(deep.zz.value == doctest::Approx(-load).epsilon(1e-10));
    CHECK(deep.xz.value == doctest::Approx(solution->resultants().tangential.value).epsilon(1e-10));
    CHECK(std::abs(deep.gradient->x_x.value) < 1e-10);
    CHECK(std::abs(deep.xx.value - deep.zz.value) > 0.1 * load);
  }
}

TEST_CASE("periodic stresses tend to those at the surface, are in equilibrium, and are those of cells") {
  for (const ContactProblem& problem : periodic_contacts()) {
    const auto solution = closed_form<double>(problem).solution;
    const auto cells = variational_inequality(problem, {.cells = 2048}).solution;
    REQUIRE(solution);
    REQUIRE(cells);
    const InteriorStress<double> stress(problem, *solution), on_cells(problem, *cells);
    for (const Rational& x : {-0.2_r, 0.3_r, 0.47_r}) {
      const StressState<double> surface = surface_stress(problem.elasticity(), solution->details_at(x));
      const StressState<double> below = stress.at(x, Rational(1, 1000000000));
      for (const Part part : stress_parts) {
        CHECK(std::abs((surface.*part).value - (below.*part).value) < 1e-6);
        for (const Rational& z : {0.1_r, 0.7_r}) {
          const Estimate<double> a = stress.at(x, z).*part, b = on_cells.at(x, z).*part;
          CHECK(std::abs(a.value - b.value) <= a.error + b.error);
          CHECK(b.error < 1e-3);
        }
      }
      CHECK(std::abs(surface.gradient->z_x.value - below.gradient->z_x.value) < 1e-6);
      CHECK(std::abs(surface.gradient->x_x.value - below.gradient->x_x.value) < 1e-6);
      constexpr double step = 1e-3;
      const auto at = [&](int i, int k) {
        return stress.on_finest_mesh(to_real<double>(x) + i * step, 0.3 + k * step);
      };
      const double along = at(1, 0).xx.value - at(-1, 0).xx.value, down = at(0, 1).xz.value - at(0, -1).xz.value;
      CHECK(std::abs(along + down) / (2 * step) < 1e-4);
      CHECK(std::abs(along) / (2 * step) > 1e-3);
    }
  }
}
