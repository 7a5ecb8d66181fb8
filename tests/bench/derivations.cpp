// The time of a derivation, and its growth with the number of friction jumps.

#include <benchmark/benchmark.h>

#include "symbolic/local/local_derivations.hpp"
#include "symbolic/riemann_hilbert/derived_contact.hpp"

using namespace steadyslide;
using namespace steadyslide::symbolic;

namespace {

ContactProblem punch(int jumps) {
  std::vector<Rational> values{Rational(1, 5)};
  std::vector<Rational> places;
  for (int k = 1; k <= jumps; ++k) {
    values.emplace_back(k * k + 2, 7);
    places.push_back(Rational(2 * k, jumps + 1) - 1);
  }
  return {Elasticity(Solid(Rational(3, 10), 1)), FrictionProfile(values, places), Indenter(-1, {{1, Polynomial()}}), 1};
}

/// A problem with numbers. Its radicals are square roots of integers, and products of radicals occur.
void problem_closed_form(benchmark::State& state) {
  const ContactProblem problem = punch(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(DerivedContact::all(problem, 30).front().derivation());
}

void problem_local_forms(benchmark::State& state) {
  const ContactProblem problem = punch(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(local_derivations(problem));
}

BENCHMARK(problem_closed_form)->DenseRange(0, 4)->Arg(8)->Unit(benchmark::kMillisecond);
BENCHMARK(problem_local_forms)->DenseRange(0, 4)->Arg(8)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
