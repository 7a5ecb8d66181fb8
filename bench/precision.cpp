// High precision: which 50-digit number, which logarithm, and which rule for the integral of one panel of a flat punch,
//
//   int over [-3/10, 1/10] of prod |x - e_j|^p_j,   five factors, e = -1, -3/10, 1/10, 4/10, 1.
//
// Peers in the same run: Boost's tanh-sinh rule, Arb's acb_calc_integrate (certified) and, where libpari-dev is
// installed, PARI's intnum.

#include <acb_calc.h>
#include <benchmark/benchmark.h>
#ifdef STEADYSLIDE_WITH_PARI
#include <pari/pari.h>
#endif

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "numeric/cauchy/power_traction.hpp"
#include "numeric/quadrature/double_exponential_grid.hpp"
#include "numeric/quadrature/jacobi_rule.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"

namespace {

using namespace steadyslide;
using namespace steadyslide::numeric;

// As many bits as Real50 has.
using BinFloat = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<std::numeric_limits<Real50>::digits, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

template <class R>
void weight_integral(benchmark::State& state) {
  using std::pow;
  const R epsilon = std::numeric_limits<R>::epsilon();
  boost::math::quadrature::tanh_sinh<R> rule(15, R(pow(epsilon, R(4))));
  const R power = R(-3) / 10;
  const R tolerance = sqrt(epsilon);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        rule.integrate([&](const R& x) { return R(pow(x, power) * pow(R(2 - x), power)); }, R(0), R(1), tolerance));
  }
}

/// Numbers that a logarithm, an exponential and a power are taken of, in turn.
template <Real R>
std::vector<R> arguments() {
  std::vector<R> result;
  R x = R(1) / 7;
  for (int i = 0; i < 64; ++i) result.push_back(x = 39 * x * (1 - x) / 10);
  return result;
}

template <Real R>
void function_of(benchmark::State& state, R (*f)(const R&)) {
  const std::vector<R> x = arguments<R>();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(f(x[i++ % x.size()]));
}

template <Real R>
R log_here(const R& x) {
  return log(x);
}
template <Real R>
R log_by_mpfr(const R& x) {
  R result;
  mpfr_log(result.backend().data(), x.backend().data(), MPFR_RNDN);
  return result;
}
template <Real R>
R exp_here(const R& x) {
  return exp(x);
}
template <Real R>
R exp_by_mpfr(const R& x) {
  R result;
  mpfr_exp(result.backend().data(), x.backend().data(), MPFR_RNDN);
  return result;
}
template <Real R>
R pow_here(const R& x) {
  return pow(x, R(-x));
}
template <Real R>
R pow_by_mpfr(const R& x) {
  R result;
  mpfr_pow(result.backend().data(), x.backend().data(), R(-x).backend().data(), MPFR_RNDN);
  return result;
}

constexpr int own = 1;  // the panel between e_1 and e_2
const std::vector<Rational> lengths{{7, 10}, {4, 10}, {3, 10}, {6, 10}};
const std::vector<Rational> powers{{-53, 100}, {11, 100}, {-23, 100}, {7, 100}, {-42, 100}};

template <Real R>
FundamentalSolution<R> five_factors() {
  std::vector<R> l;
  std::vector<Power<R>> p;
  for (const Rational& length : lengths) l.push_back(to_real<R>(length));
  for (const Rational& power : powers) p.push_back({to_real<R>(power), to_real<R>(power + 1)});
  return {R(-1), std::move(l), std::move(p)};
}

template <Real R>
PiecewiseDensity<R> density() {
  return PowerTraction<R>{five_factors<R>(), std::vector<R>(lengths.size(), R(1))}.density();
}

template <Real R>
const R& exact() {
  static const R value = static_cast<R>(tanh_sinh::panel_integral(density<Real100>()[own]).value);
  return value;
}

template <Real R>
void note_error(benchmark::State& state, const R& value) {
  state.counters["error"] = static_cast<double>(R(abs(value / exact<R>() - 1)));
}

template <Real R>
void panel_by_grid(benchmark::State& state) {
  // Without its neighbours: for an integral alone there is no place next to it at which a principal value is taken.
  PiecewiseDensity<R> panel{density<R>()[own]};
  R value;
  for (auto _ : state) value = double_exponential::Grid<R>(panel).integral();
  note_error(state, value);
}

template <Real R>
void panel_by_boost(benchmark::State& state) {
  const PiecewiseDensity<R> panels = density<R>();
  R value;
  for (auto _ : state) value = tanh_sinh::panel_integral(panels[own]).value;
  note_error(state, value);
}

/// Both end powers in one rule, made before: one logarithm a factor and one exponential a node.
template <Real R>
void panel_by_jacobi(benchmark::State& state) {
  const FundamentalSolution<R> y = five_factors<R>();
  const Panel<R>& panel = y.panel(own);
  const int nodes = digits_served<R> * 3 / 4 + 4;
  const JacobiRule<R> rule = jacobi_rule(y.powers()[own], y.powers()[own + 1], nodes);
  R value;
  for (auto _ : state) {
    R sum = 0;
    for (std::size_t i = 0; i < rule.size(); ++i) {
      const R left = panel.length * rule.from_left[i];
      sum += rule.weights[i] * y.smooth_modulus(own, {panel.left + left, left, panel.length * rule.from_right[i]});
    }
    value = sum * pow(panel.length, y.powers()[own].value + y.powers()[own + 1].plus_one);
  }
  note_error(state, value);
}

/// prod |x - e_j|^p_j dx/dtau with x = tanh(tau/2) on the panel.
int regularised(acb_ptr result, const acb_t tau, void*, slong order, slong bits) {
  const bool analytic = order != 0;
  acb_t decay, sum, base, exponent, factor;
  for (acb_ptr z : {decay, sum, base, exponent, factor}) acb_init(z);
  acb_neg(decay, tau);
  acb_exp(decay, decay, bits);
  acb_add_ui(sum, decay, 1, bits);
  acb_one(result);
  fmpq_t rational;
  fmpq_init(rational);
  const auto times = [&](const Rational& power) {
    fmpq_set_mpq(rational, power.backend().data());
    arb_set_fmpq(acb_realref(exponent), rational, bits);
    arb_zero(acb_imagref(exponent));
    acb_pow_analytic(factor, base, exponent, analytic, bits);
    acb_mul(result, result, factor, bits);
  };
  const auto set = [&](const Rational& value) {
    fmpq_set_mpq(rational, value.backend().data());
    acb_set_fmpq(base, rational, bits);
  };
  // From the panel's ends: length/(1+e^-tau) and that times e^-tau; their product over the length is dx/dtau.
  for (std::size_t j = 0; j < powers.size(); ++j) {
    const bool left = j <= own;
    set(lengths[own]);
    acb_div(base, base, sum, bits);
    if (!left) acb_mul(base, base, decay, bits);
    if (j == own || j == own + 1) {
      times(powers[j] + 1);
      continue;
    }
    Rational beyond = 0;
    for (std::size_t k = left ? j : own + 1; k < (left ? own : j); ++k) beyond += lengths[k];
    fmpq_set_mpq(rational, beyond.backend().data());
    arb_set_fmpq(acb_realref(factor), rational, bits);
    arb_zero(acb_imagref(factor));
    acb_add(base, base, factor, bits);
    times(powers[j]);
  }
  set(lengths[own]);
  acb_div(result, result, base, bits);
  fmpq_clear(rational);
  for (acb_ptr z : {decay, sum, base, exponent, factor}) acb_clear(z);
  return 0;
}

template <Real R>
void panel_by_arb(benchmark::State& state) {
  const slong bits = static_cast<slong>(digits_served<R> * 3.33) + 30;
  acb_t value, left, right;
  for (acb_ptr z : {value, left, right}) acb_init(z);
  // The tails are under 10^-digits: e^(-0.77 tau).
  acb_set_si(right, static_cast<slong>(digits_served<R> * 3));
  acb_neg(left, right);
  mag_t tolerance;
  mag_init(tolerance);
  mag_set_ui_2exp_si(tolerance, 1, -bits + 20);
  for (auto _ : state) acb_calc_integrate(value, regularised, nullptr, left, right, bits, tolerance, nullptr, bits);
  R result;
  arf_get_mpfr(result.backend().data(), arb_midref(acb_realref(value)), MPFR_RNDN);
  note_error(state, result);
  mag_clear(tolerance);
  for (acb_ptr z : {value, left, right}) acb_clear(z);
}

#ifdef STEADYSLIDE_WITH_PARI
/// intnum with the powers at both ends declared, its table made before.
template <Real R>
void panel_by_pari(benchmark::State& state) {
  static const bool started = (pari_init(64'000'000, 1000), true);
  static_cast<void>(started);
  const pari_sp begin = avma;
  long words = 0;
  setrealprecision(digits_served<R> + 2, &words);
  gp_read_str("f(x)=abs(x+1)^(-53/100)*abs(x+3/10)^(11/100)*abs(1/10-x)^(-23/100)*(4/10-x)^(7/100)*(1-x)^(-42/100)");
  gp_read_str("a=[-3/10,11/100];b=[1/10,-23/100];t=intnuminit(a,b)");
  GEN code = gp_read_str("()->intnum(x=a,b,f(x),t)");
  GEN value = nullptr;
  const pari_sp mark = avma;
  for (auto _ : state) {
    set_avma(mark);
    value = closure_callgenall(code, 0);
  }
  note_error(state, R(GENtostr(value)));
  set_avma(begin);
}
#endif

BENCHMARK(weight_integral<Real50>)->Unit(benchmark::kMillisecond);
BENCHMARK(weight_integral<BinFloat>)->Unit(benchmark::kMillisecond);

template <Real R>
void add(const std::string& digits) {
  using Measured = std::pair<const char*, R (*)(const R&)>;
  for (const auto& [name, f] : {Measured{"log", log_here<R>},
                                {"log by MPFR", log_by_mpfr<R>},
                                {"exp", exp_here<R>},
                                {"exp by MPFR", exp_by_mpfr<R>},
                                {"pow", pow_here<R>},
                                {"pow by MPFR", pow_by_mpfr<R>}}) {
    benchmark::RegisterBenchmark((name + digits).c_str(), function_of<R>, f)->Unit(benchmark::kMicrosecond);
  }
  using Integral = std::pair<const char*, void (*)(benchmark::State&)>;
  for (const auto& [name, run] : {
           Integral{"panel, Gauss-Jacobi, rule known", panel_by_jacobi<R>},
           {"panel, double-exponential grid", panel_by_grid<R>},
           {"panel, Boost's tanh-sinh", panel_by_boost<R>},
           {"panel, acb_calc_integrate", panel_by_arb<R>},
#ifdef STEADYSLIDE_WITH_PARI
           {"panel, PARI's intnum", panel_by_pari<R>},
#endif
       }) {
    benchmark::RegisterBenchmark((name + digits).c_str(), run)->Unit(benchmark::kMillisecond);
  }
}

}  // namespace

int main(int argc, char** argv) {
  add<Real50>(", 50 digits");
  add<Real100>(", 100 digits");
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
