// Traction of a flat punch with three friction jumps at 10^5 points, beside the floor: the same powers alone.

#include <benchmark/benchmark.h>

#include "numeric/closed_form/closed_form.hpp"

using namespace steadyslide;
using namespace steadyslide::numeric;

namespace {

constexpr int points = 100'000;

ContactProblem punch() {
  return {Elasticity(Solid(Rational(3, 10), 1)),
          FrictionProfile({Rational(1, 5), Rational(3, 5), Rational(1, 10), Rational(4, 5)},
                          {Rational(-1, 2), Rational(1, 10), Rational(3, 5)}),
          Indenter(-1, {{1, Polynomial()}}), 1};
}

template <Real R>
struct Setting {
  PowerTraction<R> traction = std::get<ClosedFormData<R>>(closed_form_data<R>(punch())).traction;
  std::vector<std::pair<std::size_t, Node<R>>> nodes;
  std::vector<std::vector<R>> distances;

  Setting() {
    const std::size_t panels = traction.weight.panel_count();
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t k = i % panels;
      const Panel<R>& panel = traction.weight.panel(k);
      nodes.emplace_back(k, panel.node_from_left(R(panel.length * (static_cast<double>(i) + 0.5) / points)));
      std::vector<R> d;
      for (std::size_t j = 0; j <= panels; ++j) {
        using std::abs;
        d.push_back(abs(nodes.back().second.x - traction.weight.point(j)));
      }
      distances.push_back(std::move(d));
    }
  }
};

template <Real R>
const Setting<R>& setting() {
  static const Setting<R> instance;
  return instance;
}

template <Real R>
void traction(benchmark::State& state) {
  const Setting<R>& s = setting<R>();
  for (auto _ : state) {
    for (const auto& [panel, node] : s.nodes) benchmark::DoNotOptimize(s.traction(panel, node));
  }
  state.SetItemsProcessed(state.iterations() * points);
}

template <Real R>
void floor_of_powers(benchmark::State& state) {
  const Setting<R>& s = setting<R>();
  const auto& powers = s.traction.weight.powers();
  for (auto _ : state) {
    for (const std::vector<R>& d : s.distances) {
      for (std::size_t j = 0; j < powers.size(); ++j) {
        using std::pow;
        benchmark::DoNotOptimize(pow(d[j], powers[j].value));
      }
    }
  }
  state.SetItemsProcessed(state.iterations() * points);
}

BENCHMARK(floor_of_powers<double>)->Unit(benchmark::kMillisecond);
BENCHMARK(traction<double>)->Unit(benchmark::kMillisecond);
BENCHMARK(floor_of_powers<Real50>)->Unit(benchmark::kMillisecond);
BENCHMARK(traction<Real50>)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
