// Tractions of a flat punch with three friction jumps, compared with the same powers alone, which are a lower limit,
// and in double with the logarithms and the exponential of glibc's libmvec. README.md describes how to hide instruction
// sets from glibc too.

#include <benchmark/benchmark.h>

#include "enclosure/number/ball.hpp"
#include "numeric/closed_form/closed_form.hpp"
#include "numeric/number/power_product.hpp"

using namespace steadyslide;
using namespace steadyslide::numeric;

namespace {

ContactProblem punch() {
  return {Elasticity(Solid(Rational(3, 10), 1)),
          FrictionProfile({Rational(1, 5), Rational(3, 5), Rational(1, 10), Rational(4, 5)},
                          {Rational(-1, 2), Rational(1, 10), Rational(3, 5)}),
          Indenter(-1, {{1, Polynomial()}}), 1};
}

/// The points, panel by panel, and the distances of each point from all ends and jumps.
template <Real R>
struct Setting {
  static constexpr std::size_t points = std::same_as<R, double> ? 1'000'000 : 100'000;
  ClosedForm<R> solution{punch(), std::get<ClosedFormData<R>>(closed_form_data<R>(punch()))};
  const PowerTraction<R>& traction = solution.data().traction;
  const std::vector<Power<R>>& powers = traction.weight.powers();
  std::size_t panels = traction.weight.panel_count();
  std::vector<R> x, from_left, from_right, values = std::vector<R>(points);
  std::vector<std::vector<R>> distances{panels + 1};  // from each end and jump

  Setting() {
    for (std::size_t k = 0; k < panels; ++k) {
      const Panel<R>& panel = traction.weight.panel(k);
      for (std::size_t i = 0; i < per_panel(); ++i) {
        const R part = (static_cast<double>(i) + 0.5) / static_cast<double>(per_panel());
        const Node<R> node = panel.node_from_left(panel.length * part);
        x.push_back(node.x);
        from_left.push_back(node.from_left);
        from_right.push_back(node.from_right);
        for (std::size_t j = 0; j <= panels; ++j) {
          using std::abs;
          distances[j].push_back(abs(node.x - traction.weight.point(j)));
        }
      }
    }
  }
  std::size_t per_panel() const { return points / panels; }

  static Setting& get() {
    static Setting instance;
    return instance;
  }
};

template <Real R>
void items(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(Setting<R>::points));
}

/// Measures the time of `fill`, which computes the values at all points.
template <Real R, class Fill>
void measure(benchmark::State& state, const Fill& fill) {
  Setting<R>& s = Setting<R>::get();
  for (auto _ : state) {
    fill(s);
    benchmark::DoNotOptimize(s.values.data());
  }
  items<R>(state);
}

template <Real R>
void floor_of_powers(benchmark::State& state) {
  measure<R>(state, [](Setting<R>& s) {
    for (std::size_t i = 0; i < s.points; ++i) {
      R value = 1;
      for (std::size_t j = 0; j < s.powers.size(); ++j) {
        using std::pow;
        value *= pow(s.distances[j][i], s.powers[j].value);
      }
      s.values[i] = value;
    }
  });
}

/// Computes the solution's tractions at points of panels, one by one.
template <Real R>
void one_by_one(benchmark::State& state) {
  measure<R>(state, [](Setting<R>& s) {
    for (std::size_t i = 0; i < s.points; ++i) {
      s.values[i] = s.traction(i / s.per_panel(), {s.x[i], s.from_left[i], s.from_right[i]});
    }
  });
}

/// Computes the same in one call.
template <Real R>
void on_panels(benchmark::State& state) {
  measure<R>(state, [n = Setting<R>::get().per_panel()](Setting<R>& s) {
    for (std::size_t k = 0; k < s.panels; ++k) {
      s.traction(k, std::span(s.from_left).subspan(k * n, n), std::span(s.from_right).subspan(k * n, n),
                 std::span(s.values).subspan(k * n, n));
    }
  });
}

/// Computes tractions and shear at given x.
template <Real R>
void at_places(benchmark::State& state) {
  std::vector<R> shear(Setting<R>::points);
  measure<R>(state, [&](Setting<R>& s) { s.solution.tractions(s.x, s.values, shear); });
}

/// The competitor in high precision: logarithms of the distances and one exponential by Arb, as an enclosure.
template <Real R>
void arb_kernel(benchmark::State& state) {
  Setting<R>& s = Setting<R>::get();
  constexpr slong bits = static_cast<slong>(digits_served<R> / 0.30103) + 1;
  const auto balls = [](const std::vector<R>& values) {
    std::vector<enclosure::Ball> list(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) arf_set_mpfr(arb_midref(list[i].get()), values[i].backend().data());
    return list;
  };
  std::vector<R> powers;
  for (const Power<R>& power : s.powers) powers.push_back(power.value);
  const std::vector<enclosure::Ball> power = balls(powers);
  std::vector<std::vector<enclosure::Ball>> distances;
  for (const std::vector<R>& list : s.distances) distances.push_back(balls(list));
  std::vector<enclosure::Ball> values = balls(s.values);
  enclosure::Ball sum, log;
  for (auto _ : state) {
    for (std::size_t i = 0; i < s.points; ++i) {
      arb_zero(sum.get());
      for (std::size_t j = 0; j < distances.size(); ++j) {
        arb_log(log.get(), distances[j][i].get(), bits);
        arb_addmul(sum.get(), log.get(), power[j].get(), bits);
      }
      arb_exp(values[i].get(), sum.get(), bits);
    }
    benchmark::DoNotOptimize(values);
  }
  items<R>(state);
}

/// Runs the kernel of an instruction set on the points of one panel.
void kernel(benchmark::State& state, InstructionSet set) {
  const std::vector<Power<double>>& powers = Setting<double>::get().powers;
  std::vector<PowerFactor> of_left, of_right;
  for (std::size_t j = 0; j < powers.size(); ++j) {
    (j < 2 ? of_left : of_right)
        .emplace_back(j < 2 ? 0.5 * (1.0 - static_cast<double>(j)) : 0.4 * (static_cast<double>(j) - 2),
                      powers[j].value);
  }
  measure<double>(
      state, [&](Setting<double>& s) { power_products(of_left, of_right, s.from_left, s.from_right, s.values, set); });
}

#ifdef __x86_64__
typedef double Two __attribute__((vector_size(16)));
typedef double Four __attribute__((vector_size(32)));
typedef double Eight __attribute__((vector_size(64)));
extern "C" {
Two _ZGVbN2v_log(Two);
Two _ZGVbN2v_exp(Two);
__attribute__((target("avx2,fma"))) Four _ZGVdN4v_log(Four);
__attribute__((target("avx2,fma"))) Four _ZGVdN4v_exp(Four);
__attribute__((target("avx512f"))) Eight _ZGVeN8v_log(Eight);
__attribute__((target("avx512f"))) Eight _ZGVeN8v_exp(Eight);
}

// A sum of logarithms in double. It has the time of libmvec, but not the accuracy of a product of powers.
#define STEADYSLIDE_LIBMVEC(name, Vector, target, log, exp)                         \
  target void name(benchmark::State& state) {                                       \
    Setting<double>& s = Setting<double>::get();                                    \
    for (auto _ : state) {                                                          \
      for (std::size_t i = 0; i < s.points; i += sizeof(Vector) / sizeof(double)) { \
        Vector sum{};                                                               \
        for (std::size_t j = 0; j < s.powers.size(); ++j) {                         \
          Vector d;                                                                 \
          __builtin_memcpy(&d, &s.distances[j][i], sizeof d);                       \
          sum += s.powers[j].value * log(d);                                        \
        }                                                                           \
        sum = exp(sum);                                                             \
        __builtin_memcpy(&s.values[i], &sum, sizeof sum);                           \
      }                                                                             \
      benchmark::DoNotOptimize(s.values.data());                                    \
    }                                                                               \
    items<double>(state);                                                           \
  }
STEADYSLIDE_LIBMVEC(libmvec_baseline, Two, , _ZGVbN2v_log, _ZGVbN2v_exp)
STEADYSLIDE_LIBMVEC(libmvec_avx2, Four, __attribute__((target("avx2,fma"))), _ZGVdN4v_log, _ZGVdN4v_exp)
STEADYSLIDE_LIBMVEC(libmvec_avx512, Eight, __attribute__((target("avx512f"))), _ZGVeN8v_log, _ZGVeN8v_exp)
#undef STEADYSLIDE_LIBMVEC
#endif

}  // namespace

int main(int argc, char** argv) {
  const auto add = [](const char* name, auto run) {
    benchmark::RegisterBenchmark(name, run)->Unit(benchmark::kMillisecond);
  };
  const std::vector<InstructionSet>& sets = instruction_sets();
  const auto with = [](InstructionSet set) { return [set](benchmark::State& state) { kernel(state, set); }; };
  add("double/floor", floor_of_powers<double>);
  add("double/one_by_one", one_by_one<double>);
  add("double/at_places", at_places<double>);
  add("double/on_panels", on_panels<double>);
  add("double/kernel/baseline", with(InstructionSet::baseline));
  if (sets.size() > 1) add("double/kernel/avx2", with(InstructionSet::avx2));
  if (sets.size() > 2) add("double/kernel/avx512", with(InstructionSet::avx512));
#ifdef __x86_64__
  add("double/libmvec/baseline", libmvec_baseline);
  if (sets.size() > 1) add("double/libmvec/avx2", libmvec_avx2);
  if (sets.size() > 2) add("double/libmvec/avx512", libmvec_avx512);
#endif
  add("50 digits/floor", floor_of_powers<Real50>);
  add("50 digits/arb", arb_kernel<Real50>);
  add("50 digits/on_panels", on_panels<Real50>);
  add("100 digits/arb", arb_kernel<Real100>);
  add("100 digits/on_panels", on_panels<Real100>);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
