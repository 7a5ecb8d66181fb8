// Enclosed integrals of the flat-punch type: int_{-1}^{1} prod_j |x - e_j|^(p_j) dx with 0 to 5 friction jumps,
// compared with Arb's own adaptive integrator on the same integral, regularised, and with Gamma functions if there is
// no jump.

#include <benchmark/benchmark.h>

#include "tests/bench/arb_integral.hpp"

namespace {

using namespace steadyslide;
using namespace steadyslide::enclosure;

PowerIntegrand flat_punch(int jumps, Bits bits) {
  const Rational slopes[] = {{1, 10}, {6, 10}, {1, 5}, {2, 1}, {1, 20}, {1, 3}};
  const Rational places[] = {{-7, 10}, {-3, 10}, {1, 10}, {4, 10}, {8, 10}};
  const auto angle = [&](int k) { return atan(Ball(slopes[k], bits)) / Ball::pi(bits); };
  const Ball half(Rational(1, 2), bits);
  PowerIntegrand result;
  result.points.push_back(Ball(-1, bits));
  result.powers.push_back(-half - angle(0));
  for (int k = 0; k < jumps; ++k) {
    result.points.push_back(Ball(places[k], bits));
    result.powers.push_back(angle(k) - angle(k + 1));
  }
  result.points.push_back(Ball(1, bits));
  result.powers.push_back(angle(jumps) - half);
  return result;
}

void count_digits(benchmark::State& state, const Ball& value) {
  state.counters["digits"] = static_cast<double>(arb_rel_accuracy_bits(value.get())) * 0.30103;
}

void ours(benchmark::State& state, Route route, bool warm) {
  const Bits bits = bits_for(static_cast<int>(state.range(1)));
  const PowerIntegrand integrand = flat_punch(static_cast<int>(state.range(0)), bits);
  const std::size_t last = integrand.points.size() - 1;
  JacobiRules kept(bits);
  Ball value = warm ? enclosed_integral(integrand, 0, last, route, kept).value : Ball(0);
  for (auto _ : state) {
    JacobiRules made(bits);
    value = enclosed_integral(integrand, 0, last, route, warm ? kept : made).value;
  }
  count_digits(state, value);
}

void arb_integrator(benchmark::State& state) {
  const Bits bits = bits_for(static_cast<int>(state.range(1)));
  const PowerIntegrand integrand = flat_punch(static_cast<int>(state.range(0)), bits);
  Ball sum(0, bits);
  for (auto _ : state) {
    sum = Ball(0, bits);
    for (std::size_t k = 0; k + 1 < integrand.points.size(); ++k) sum += bench::arb_integral(integrand, k, bits);
  }
  count_digits(state, sum);
}

void gamma_functions(benchmark::State& state) {
  const Bits bits = bits_for(static_cast<int>(state.range(1)));
  const PowerIntegrand integrand = flat_punch(0, bits);
  Ball value(0);
  for (auto _ : state) {
    const Ball a = integrand.powers[0] + 1, b = integrand.powers[1] + 1;
    value = power(Ball(2, bits), a + b - 1) * gamma(a) * gamma(b) / gamma(a + b);
  }
  count_digits(state, value);
}

}  // namespace

int main(int argc, char** argv) {
  const auto add = [](const char* name, auto run, int most_jumps, const std::vector<std::int64_t>& digits) {
    benchmark::RegisterBenchmark(name, run)
        ->ArgsProduct({benchmark::CreateDenseRange(0, most_jumps, 1), digits})
        ->ArgNames({"jumps", "digits"})
        ->Unit(benchmark::kMillisecond);
  };
  const auto by = [](Route route, bool warm) { return [=](benchmark::State& state) { ours(state, route, warm); }; };
  add("panels_warm", by(Route::panels, true), 5, {30, 50, 200, 1000});
  add("panels_cold", by(Route::panels, false), 5, {30, 50, 200, 1000});
  add("witness", by(Route::trapezoidal, false), 5, {30, 50, 200, 1000});
  // Arb's integrator takes minutes at 200 digits and hours at 1000.
  add("arb_integrator", arb_integrator, 5, {30, 50, 200});
  add("gamma_functions", gamma_functions, 0, {30, 50, 200, 1000});
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
