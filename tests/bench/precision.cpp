// High precision: comparison of 50-digit number types, of logarithms, and of rules for the integral of one panel of a
// flat punch,
//
//   int over [-3/10, 1/10] of prod |x - e_j|^p_j,   five factors, e = -1, -3/10, 1/10, 4/10, 1.
//
// Competitors in the same run: Boost's tanh-sinh rule, Arb's acb_calc_integrate (certified) and, if libpari-dev is
// installed, PARI's intnum.

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
#include "tests/bench/arb_integral.hpp"

namespace {

using namespace steadyslide;
using namespace steadyslide::numeric;

// This type has the same number of bits as Real50.
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

/// The arguments of a logarithm, an exponential and a power, used in turn.
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

template <Real R, auto f>
R by_mpfr(const R& x) {
  R result;
  f(result.backend().data(), x.backend().data(), MPFR_RNDN);
  return result;
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
  // The panel has no neighbours, because an integral alone needs no principal values next to it.
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

/// A precomputed rule with both end powers: one logarithm for each factor and one exponential for each node.
template <Real R>
void panel_by_jacobi(benchmark::State& state) {
  const FundamentalSolution<R> y = five_factors<R>();
  const Panel<R>& panel = y.panel(own);
  const int nodes = digits_served<R> * 3 / 4 + 4;
  const UnitRule<R> rule = jacobi_rule(y.powers()[own], y.powers()[own + 1], nodes);
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

template <Real R>
void panel_by_arb(benchmark::State& state) {
  const slong bits = static_cast<slong>(digits_served<R> * 3.33) + 10;
  bench::PowerIntegrand integrand{{enclosure::Ball(-1, bits)}, {}};
  for (const Rational& length : lengths) {
    integrand.points.push_back(integrand.points.back() + enclosure::Ball(length, bits));
  }
  for (const Rational& power : powers) integrand.powers.emplace_back(power, bits);
  enclosure::Ball value;
  for (auto _ : state) value = bench::arb_integral(integrand, own, bits);
  R result;
  arf_get_mpfr(result.backend().data(), arb_midref(value.get()), MPFR_RNDN);
  note_error(state, result);
}

#ifdef STEADYSLIDE_WITH_PARI
/// intnum with declared powers at both ends and a precomputed table.
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
  for (const auto& [name, f] : {Measured{"log", [](const R& x) { return log(x); }},
                                {"log by MPFR", by_mpfr<R, mpfr_log>},
                                {"exp", [](const R& x) { return exp(x); }},
                                {"exp by MPFR", by_mpfr<R, mpfr_exp>},
                                {"pow", [](const R& x) { return pow(x, R(-x)); }},
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
