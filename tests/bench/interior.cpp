// Stresses below the surface at 10^5 points on one core: a closed form, the Riemann-Hilbert method and cells, compared
// with a direct sum over the forces at the nodes of all panels of the closed form's traction; and the nodal forces of a
// mesh.

#include <benchmark/benchmark.h>

#include <cmath>

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/interior/largest_stress.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/solution/nodal_forces.hpp"
#include "numeric/variational/variational_inequality.hpp"

using namespace steadyslide;
using namespace steadyslide::numeric;

namespace {

constexpr std::size_t points = 100'000;
using Solution = std::shared_ptr<const ContactSolution<double>>;

/// Returns a parabola over a friction jump.
ContactProblem problem() {
  return {Elasticity(Solid(Rational(3, 10), 1)), FrictionProfile({Rational(1, 10), Rational(3, 5)}, {Rational(1, 10)}),
          Indenter(-2, {{2, Polynomial({0, 0, 1})}}), 1};
}

Solution by_formula() { return closed_form<double>(problem()).solution; }
Solution by_form() { return riemann_hilbert<double>(problem()).solution; }
Solution by_cells() { return variational_inequality(problem()).solution; }

/// A grid below the contact and beside it: equal steps along x, and depths from `least` to 1.
struct Grid {
  explicit Grid(double least) {
    constexpr std::size_t across = 400;
    for (std::size_t i = 0; i < points; ++i) {
      const double row = static_cast<double>(i / across) / static_cast<double>(points / across - 1);
      x.push_back(2 * static_cast<double>(i % across) / across - 1);
      z.push_back(least * std::pow(1 / least, row));
    }
  }
  std::vector<double> x, z;
  std::vector<StressState<double>> states{points};
};

void stresses(benchmark::State& state, Solution (*solve)(), double least) {
  const Solution solution = solve();
  Grid grid(least);
  for (auto _ : state) {
    const InteriorStress<double> interior(*solution);
    interior.at(grid.x, grid.z, grid.states);
    benchmark::DoNotOptimize(grid.states.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
}

void floor_of_forces(benchmark::State& state) {
  const PiecewiseTraction<double> traction = by_formula()->piecewise_traction();
  std::vector<double> x, force;
  TractionNodes<double> nodes;
  for (const TractionPanel<double>& panel : traction.panels()) {
    nodes.clear();
    traction.append_nodes(panel, nodes);
    for (std::size_t i = 0; i < nodes.forces.size(); ++i) {
      x.push_back(panel.left.high + nodes.from_left[i]);
      force.push_back(nodes.forces[i]);
    }
  }
  const Grid grid(1e-3);
  for (auto _ : state) {
    for (std::size_t i = 0; i < points; ++i) {
      std::array<double, 4> sums{};
      for (std::size_t k = 0; k < x.size(); ++k)
        StressKernel<double>::add_force(sums, force[k], grid.x[i] - x[k], grid.z[i]);
      benchmark::DoNotOptimize(sums);
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
}

void largest(benchmark::State& state, Solution (*solve)()) {
  const Solution solution = solve();
  const InteriorStress<double> interior(*solution);
  for (auto _ : state) benchmark::DoNotOptimize(largest_stress(interior, 0.01));
}

void forces_on_mesh(benchmark::State& state) {
  std::vector<Rational> nodes;
  for (int k = -10000; k <= 10000; ++k) nodes.push_back(Rational(k, 10000));
  const SurfaceMesh mesh(nodes, 2);
  const PiecewiseTraction<double> traction = by_formula()->piecewise_traction();
  for (auto _ : state) benchmark::DoNotOptimize(nodal_forces(traction, mesh));
}

BENCHMARK(floor_of_forces)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stresses, closed_form, by_formula, 1e-3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stresses, riemann_hilbert, by_form, 1e-3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stresses, riemann_hilbert_down_to_1e_8, by_form, 1e-8)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stresses, cells, by_cells, 1e-3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(largest, closed_form, by_formula)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(largest, cells, by_cells)->Unit(benchmark::kMillisecond);
BENCHMARK(forces_on_mesh)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
