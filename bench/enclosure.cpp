// Enclosed integrals of the flat-punch type: int_{-1}^{1} prod_j |x - e_j|^(p_j) dx with 0 to 5 friction jumps, beside
// Arb's own adaptive integrator on the same integral, regularised, and the Gamma functions where there is no jump.

#include <acb_calc.h>
#include <benchmark/benchmark.h>

#include "enclosure/quadrature/enclosed_integral.hpp"

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

void panels_warm(benchmark::State& state) { ours(state, Route::panels, true); }
void panels_cold(benchmark::State& state) { ours(state, Route::panels, false); }
void witness(benchmark::State& state) { ours(state, Route::trapezoidal, false); }

/// One piece between two points, x = tanh(tau/2) on it: products of powers, each by Arb's own function.
struct Piece {
  Ball length;
  Ball left;
  Ball right;
  std::vector<std::pair<Ball, Ball>> on_left;  ///< distance, power
  std::vector<std::pair<Ball, Ball>> on_right;
};

/// result *= base^power, holomorphic where that is asked for.
void multiply(acb_t result, const acb_t base, const Ball& power, bool analytic, slong bits) {
  acb_t exponent, value;
  acb_init(exponent);
  acb_init(value);
  acb_set_arb(exponent, power.get());
  acb_pow_analytic(value, base, exponent, analytic, bits);
  acb_mul(result, result, value, bits);
  acb_clear(exponent);
  acb_clear(value);
}

int integrand_of_piece(acb_ptr result, const acb_t tau, void* parameters, slong order, slong bits) {
  if (order > 1) flint_abort();
  const Piece& piece = *static_cast<const Piece*>(parameters);
  const bool analytic = order != 0;
  acb_t e, from_left, from_right, base;
  for (acb_ptr z : {e, from_left, from_right, base}) acb_init(z);
  acb_neg(e, tau);
  acb_exp(e, e, bits);
  acb_add_ui(from_left, e, 1, bits);
  acb_inv(from_left, from_left, bits);
  acb_exp(e, tau, bits);
  acb_add_ui(from_right, e, 1, bits);
  acb_inv(from_right, from_right, bits);
  acb_mul_arb(from_left, from_left, piece.length.get(), bits);
  acb_mul_arb(from_right, from_right, piece.length.get(), bits);
  acb_one(result);
  multiply(result, from_left, piece.left + 1, analytic, bits);
  multiply(result, from_right, piece.right + 1, analytic, bits);
  acb_div_arb(result, result, piece.length.get(), bits);
  for (const auto& [distance, power] : piece.on_left) {
    acb_add_arb(base, from_left, distance.get(), bits);
    multiply(result, base, power, analytic, bits);
  }
  for (const auto& [distance, power] : piece.on_right) {
    acb_add_arb(base, from_right, distance.get(), bits);
    multiply(result, base, power, analytic, bits);
  }
  for (acb_ptr z : {e, from_left, from_right, base}) acb_clear(z);
  return 0;
}

/// Cut off where the integrand is below 2^-bits, which is left out here.
void arb_integrator(benchmark::State& state) {
  const Bits bits = bits_for(static_cast<int>(state.range(1)));
  const PowerIntegrand integrand = flat_punch(static_cast<int>(state.range(0)), bits);
  const std::vector<Ball>&e = integrand.points, &p = integrand.powers;
  Ball sum(0, bits);
  for (auto _ : state) {
    sum = Ball(0, bits);
    for (std::size_t k = 0; k + 1 < e.size(); ++k) {
      Piece piece{e[k + 1] - e[k], p[k], p[k + 1], {}, {}};
      for (std::size_t j = 0; j < k; ++j) piece.on_left.emplace_back(e[k] - e[j], p[j]);
      for (std::size_t j = k + 2; j < e.size(); ++j) piece.on_right.emplace_back(e[j] - e[k + 1], p[j]);
      const double decay = static_cast<double>(bits) * 0.693;
      acb_t from, to, value;
      for (acb_ptr z : {from, to, value}) acb_init(z);
      acb_set_d(from, -decay / (piece.left.to_double() + 1));
      acb_set_d(to, decay / (piece.right.to_double() + 1));
      mag_t tolerance;
      mag_init(tolerance);
      mag_set_ui_2exp_si(tolerance, 1, -bits);
      acb_calc_integrate_opt_t options;
      acb_calc_integrate_opt_init(options);
      options->eval_limit = 100000000;
      options->depth_limit = 100000;
      acb_calc_integrate(value, integrand_of_piece, &piece, from, to, bits, tolerance, options, bits);
      Ball real(0, bits);
      acb_get_real(real.get(), value);
      sum += real;
      for (acb_ptr z : {from, to, value}) acb_clear(z);
      mag_clear(tolerance);
    }
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

void up_to_1000_digits(benchmark::internal::Benchmark* run) {
  for (const int digits : {30, 50, 200, 1000}) {
    for (int jumps = 0; jumps <= 5; ++jumps) run->Args({jumps, digits});
  }
}

/// Arb's integrator takes minutes at 200 digits and hours at 1000.
void up_to_200_digits(benchmark::internal::Benchmark* run) {
  for (const int digits : {30, 50, 200}) {
    for (int jumps = 0; jumps <= 5; ++jumps) run->Args({jumps, digits});
  }
}

BENCHMARK(panels_warm)->Apply(up_to_1000_digits)->ArgNames({"jumps", "digits"})->Unit(benchmark::kMillisecond);
BENCHMARK(panels_cold)->Apply(up_to_1000_digits)->ArgNames({"jumps", "digits"})->Unit(benchmark::kMillisecond);
BENCHMARK(witness)->Apply(up_to_1000_digits)->ArgNames({"jumps", "digits"})->Unit(benchmark::kMillisecond);
BENCHMARK(arb_integrator)->Apply(up_to_200_digits)->ArgNames({"jumps", "digits"})->Unit(benchmark::kMillisecond);
BENCHMARK(gamma_functions)
    ->ArgsProduct({{0}, {30, 50, 200, 1000}})
    ->ArgNames({"jumps", "digits"})
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
