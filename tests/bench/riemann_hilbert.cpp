// The Riemann-Hilbert solver compared with the coarse solution of about 1,024 cells and with the same formula
// evaluated only by GSL; and the cost of a solve and of a traction value by the number of friction jumps. The counters
// `ends` and `traction` are the relative errors against 50 digits.

#include <benchmark/benchmark.h>

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/quadrature/gsl_quadrature.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "numeric/variational/coarse_contact.hpp"

using namespace steadyslide;
using namespace steadyslide::numeric;

namespace {

/// Returns a rounded punch: one polynomial, or two that meet in a wedge; friction jumps at equal distances over the
/// support.
ContactProblem punch(int jumps, bool wedge) {
  std::vector<Rational> values;
  std::vector<Rational> places;
  for (int k = 0; k <= jumps; ++k) {
    values.emplace_back((k * 37) % 19, 20);
    if (k > 0) places.push_back(Rational(-9, 10) + Rational(18 * k, 10 * (jumps + 1)));
  }
  const Rational half(1, 2);
  std::vector<Indenter::Piece> pieces;
  if (wedge) {
    pieces = {{0, Polynomial({0, Rational(-1, 4), half, 0, 1})}, {1, Polynomial({0, Rational(1, 4), half, half, 1})}};
  } else {
    pieces = {{1, Polynomial({0, Rational(1, 10), half, 0, 1})}};
  }
  return {Elasticity(Solid(Rational(3, 10), 1)), FrictionProfile(values, places), Indenter(-1, pieces), half};
}

constexpr int few = 3;

template <Real R>
const ContactSolution<R>& solution(int jumps, bool wedge) {
  static std::map<std::pair<int, bool>, std::shared_ptr<const ContactSolution<R>>> known;
  auto& slot = known[{jumps, wedge}];
  if (!slot) slot = riemann_hilbert<R>(punch(jumps, wedge)).solution;
  return *slot;
}

double error_of_ends(double left, double right, bool wedge) {
  const auto exact = solution<Real50>(few, wedge).contact().front();
  const Real50 width = exact.right.x.value - exact.left.x.value;
  const Real50 worst = std::max<Real50>(abs(left - exact.left.x.value), abs(right - exact.right.x.value));
  return static_cast<double>(Real50(worst / width));
}

void solve_cold(benchmark::State& state, bool wedge) {
  const ContactProblem problem = punch(few, wedge);
  for (auto _ : state) benchmark::DoNotOptimize(riemann_hilbert<double>(problem));
  const auto zone = solution<double>(few, wedge).contact().front();
  state.counters["ends"] = error_of_ends(zone.left.x.value, zone.right.x.value, wedge);
}

template <Real R>
void solve_warm(benchmark::State& state, bool wedge) {
  const ContactProblem problem = punch(few, wedge);
  const ContactSolution<R>& start = solution<R>(few, wedge);
  for (auto _ : state) benchmark::DoNotOptimize(riemann_hilbert<R>(problem, &start));
}

template <Real R>
void solve_from_nothing(benchmark::State& state, bool wedge) {
  const ContactProblem problem = punch(few, wedge);
  for (auto _ : state) benchmark::DoNotOptimize(riemann_hilbert<R>(problem));
}

void coarse_1024(benchmark::State& state, bool wedge) {
  const ContactProblem problem = punch(few, wedge);
  CoarseContact coarse;
  for (auto _ : state) coarse = coarse_contact(problem, 1024);
  const double origin = to_real<double>(coarse.origin);
  state.counters["ends"] = error_of_ends(origin + coarse.zones.front().left, origin + coarse.zones.back().right, wedge);
}

Rational place() { return {1, 7}; }

/// Records the error of a traction at place().
void note_error(benchmark::State& state, double t, bool wedge) {
  const Real50 exact = solution<Real50>(few, wedge).at(place()).traction.left.value;
  state.counters["traction"] = static_cast<double>(Real50(abs(t - exact) / abs(exact)));
}

void traction(benchmark::State& state, bool wedge) {
  const ContactSolution<double>& s = solution<double>(few, wedge);
  double t = 0;
  for (auto _ : state) {
    t = s.at(place()).traction.left.value;
    benchmark::DoNotOptimize(t);
  }
  note_error(state, t, wedge);
}

/// t = s g/(1+s^2) - eps cos(pi alpha) |Y| (1/pi) PV int eps cos(pi alpha) g/|Y| dx'/(x'-x), by QAWS and QAWC only.
void traction_by_gsl(benchmark::State& state, bool wedge) {
  const auto& s = dynamic_cast<const RiemannHilbertSolution<double>&>(solution<double>(few, wedge));
  const TractionRepresentation<double>& form = s.form();
  const ContactSet<double>& set = form.set();
  PiecewiseDensity<double> density;
  std::vector<std::size_t> segments;
  for (std::size_t k = 0; k < set.segments(); ++k) {
    if (!set.in_contact(k)) continue;
    const auto inverse = [&](std::size_t j) {
      const Power<double>& p = form.fundamental_solution().powers()[j];
      return Power<double>{-p.value, 1 - p.value};
    };
    const double factor = form.y().traction_factor(k);
    density.push_back({set.panels()[k], inverse(k), inverse(k + 1), [&form, k, factor](const Node<double>& node) {
                         return factor * form.problem().slope(form.slope_at(k), node.x) /
                                form.fundamental_solution().smooth_modulus(k, node);
                       }});
    segments.push_back(k);
  }
  const Frame& frame = form.problem().frame();
  const double xi = to_real<double>((place() - frame.origin) / frame.unit);
  std::size_t panel = 0;
  while (density[panel].panel.right < xi) ++panel;
  const Node<double> node{xi, xi - density[panel].panel.left, density[panel].panel.right - xi};
  const std::size_t segment = segments[panel];
  const double friction = form.problem().s(form.friction_at(segment));
  const double g = form.problem().slope(form.slope_at(segment), xi);
  const double factor = form.y().traction_factor(segment);
  double t = 0;
  for (auto _ : state) {
    const double integral = gsl::hilbert(density, {panel, node}).value;
    t = friction * g / (1 + friction * friction) -
        factor * form.fundamental_solution().modulus(segment, node) * integral;
    benchmark::DoNotOptimize(t);
  }
  note_error(state, t, wedge);
}

void solve_by_jumps(benchmark::State& state, bool wedge) {
  const ContactProblem problem = punch(static_cast<int>(state.range(0)), wedge);
  const ContactSolution<double>& start = solution<double>(static_cast<int>(state.range(0)), wedge);
  for (auto _ : state) benchmark::DoNotOptimize(riemann_hilbert<double>(problem, &start));
  state.SetComplexityN(state.range(0));
}

void traction_by_jumps(benchmark::State& state, bool wedge) {
  const ContactSolution<double>& s = solution<double>(static_cast<int>(state.range(0)), wedge);
  for (auto _ : state) benchmark::DoNotOptimize(s.at(place()));
  state.SetComplexityN(state.range(0));
}

}  // namespace

int main(int argc, char** argv) {
  using Measured = std::pair<const char*, void (*)(benchmark::State&, bool)>;
  const auto each_profile = [](const Measured& measured) {
    const auto& [name, run] = measured;
    return std::array{benchmark::RegisterBenchmark((name + std::string("/quartic")).c_str(), run, false),
                      benchmark::RegisterBenchmark((name + std::string("/wedge")).c_str(), run, true)};
  };
  for (const Measured& measured : {Measured("solve_cold", solve_cold),
                                   {"solve_warm", solve_warm<double>},
                                   {"coarse_1024", coarse_1024},
                                   {"solve_50_digits", solve_from_nothing<Real50>},
                                   {"solve_50_digits_warm", solve_warm<Real50>},
                                   {"solve_100_digits", solve_from_nothing<Real100>},
                                   {"traction", traction},
                                   {"traction_by_gsl", traction_by_gsl}}) {
    for (auto* benchmark : each_profile(measured)) benchmark->Unit(benchmark::kMicrosecond);
  }
  for (const Measured& by_jumps :
       {Measured("solve_by_jumps", solve_by_jumps), {"traction_by_jumps", traction_by_jumps}}) {
    for (auto* benchmark : each_profile(by_jumps)) {
      benchmark->RangeMultiplier(4)->Range(4, 1024)->Unit(benchmark::kMicrosecond)->Complexity();
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
