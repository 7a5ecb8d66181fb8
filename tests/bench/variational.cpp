// The variational solver for several numbers of cells, on a parabola over two friction jumps and on a hundred
// asperities; its operator product compared with the two Fourier transforms that it contains. The counters are
// `products`, the operator products on the finest mesh; `zones`, the contact components; `natural`, the certificate's
// residual; `peak_MB`, the peak memory of the process so far.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <random>

#include "numeric/variational/nested_solve.hpp"

using namespace steadyslide;
using namespace steadyslide::numeric;
using namespace steadyslide::numeric::variational;

namespace {

const FrictionProfile& two_jumps() {
  static const FrictionProfile friction({Rational(1, 5), Rational(4, 5), Rational(2, 5)},
                                        {Rational(-1, 5), Rational(1, 10)});
  return friction;
}

ContactProblem parabola() {
  return {Elasticity(Solid(Rational(3, 10), 1)), two_jumps(), Indenter(-1, {{1, Polynomial({0, 0, Rational(5, 2)})}}),
          1};
}

/// Returns a hundred parabolic asperities of random heights on a wide parabola; about half of them are in contact.
ContactProblem asperities() {
  constexpr int count = 100;
  std::mt19937_64 random(2016);
  std::vector<Indenter::Piece> pieces;
  for (int k = 0; k < count; ++k) {
    const Rational centre = Rational(2 * k + 1, count) - 1;
    const Rational height = centre * centre / 20 + Rational(static_cast<long>(random() % 1000), 1000000);
    const Polynomial x({-centre, 1});
    pieces.push_back(
        {Rational(2 * (k + 1), count) - 1, Polynomial::constant(height) + Polynomial::constant(10) * x * x});
  }
  return {Elasticity(Solid(Rational(3, 10), 1)), two_jumps(), Indenter(-1, std::move(pieces)), Rational(1, 50)};
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void solve(benchmark::State& state, ContactProblem (*make)()) {
  const ContactProblem problem = make();
  VariationalOptions options;
  options.cells = static_cast<std::size_t>(state.range(0));
  for (auto _ : state) {
    const NestedResult result = solve_nested(problem, options);
    if (!result.certificate.accepted()) state.SkipWithError("not accepted");
    const CellSet& contact = result.fine.found.contact;
    int zones = contact.front();
    for (std::size_t i = 1; i < contact.size(); ++i) zones += contact[i] && !contact[i - 1];
    state.counters["products"] = result.fine.found.products;
    state.counters["zones"] = zones;
    state.counters["natural"] = result.certificate.natural;
  }
  state.counters["peak_MB"] = peak_megabytes();
  state.SetComplexityN(state.range(0));
}

void product(benchmark::State& state) {
  const ContactProblem problem = parabola();
  const DiscreteProblem discrete(problem, CellMesh(problem, static_cast<std::size_t>(state.range(0))));
  const std::vector<double> p(discrete.size(), 1.0);
  std::vector<double> result(discrete.size());
  for (auto _ : state) discrete.galerkin_operator().multiply(p, result);
}

void two_transforms(benchmark::State& state) {
  const ContactProblem problem = parabola();
  const CellMesh mesh(problem, static_cast<std::size_t>(state.range(0)));
  const GalerkinOperator influence(mesh, cell_friction(problem, mesh));
  const Fourier fourier(influence.transform_size());
  const std::span<double> values = fourier.values();
  std::fill(values.begin(), values.end(), 1.0);
  const std::vector<std::complex<double>> ones(fourier.modes().size(), 1.0);
  for (auto _ : state) {
    fourier.forward();
    fourier.convolve(ones, values);
    benchmark::ClobberMemory();
  }
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->RangeMultiplier(4)->Range(1 << 12, 1 << 20)->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(product)->Apply(sizes);
BENCHMARK(two_transforms)->Apply(sizes);
BENCHMARK_CAPTURE(solve, parabola, parabola)->Apply(sizes);
BENCHMARK_CAPTURE(solve, asperities, asperities)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
