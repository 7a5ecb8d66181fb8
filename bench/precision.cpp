// Which 50-digit number? The same tanh-sinh integral of an end-singular weight in MPFR and in cpp_bin_float.

#include <benchmark/benchmark.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "numeric/number/real.hpp"

namespace {

using steadyslide::numeric::Real50;
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

BENCHMARK(weight_integral<Real50>)->Unit(benchmark::kMillisecond);
BENCHMARK(weight_integral<BinFloat>)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
