// A complete answer in high precision compared with the bare solution: the output of `solve`, ends, singular points,
// resultants, error estimates and residuals, all in one process.

#include <benchmark/benchmark.h>

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"

using namespace steadyslide;
using namespace steadyslide::numeric;

namespace {

using Pieces = std::vector<Indenter::Piece>;

ContactProblem problem(std::vector<Rational> friction, std::vector<Rational> jumps, const Rational& left, Pieces pieces,
                       const Rational& load) {
  return {Elasticity(Solid(Rational(3, 10), 1)), FrictionProfile(std::move(friction), std::move(jumps)),
          Indenter(left, std::move(pieces)), load};
}

ContactProblem wedge(const Rational& load) {
  const Rational tenth(1, 10);
  return problem({Rational(6, 10), Rational(2, 10)}, {0}, -1,
                 {{0, Polynomial({0, -tenth})}, {1, Polynomial({0, tenth})}}, load);
}

const std::vector<std::pair<const char*, ContactProblem>>& problems() {
  const Rational tenth(1, 10);
  static const std::vector<std::pair<const char*, ContactProblem>> all{
      {"punch", problem({Rational(3, 10)}, {}, -1, {{1, Polynomial({0})}}, 1)},
      {"parabola", problem({Rational(4, 10)}, {}, -2, {{2, Polynomial({0, 0, Rational(1, 2)})}}, Rational(1, 2))},
      {"wedge, all in contact", wedge(1)},
      {"wedge, partly", wedge(Rational(1, 20))},
      {"two zones", problem({tenth, Rational(7, 10)}, {0}, -2,
                            {{2, Polynomial({Rational(1, 4), 0, Rational(-1, 2), 0, Rational(1, 4)})}}, tenth)}};
  return all;
}

template <Real R>
void bare(benchmark::State& state, const ContactProblem& problem) {
  for (auto _ : state) benchmark::DoNotOptimize(riemann_hilbert<R>(problem));
}

/// Computes all that `solve` prints. Returns the residual of the equation.
template <Real R>
double ask(const ContactSolution<R>& solution) {
  benchmark::DoNotOptimize(solution.contact());
  benchmark::DoNotOptimize(solution.singular_points());
  benchmark::DoNotOptimize(solution.resultants());
  benchmark::DoNotOptimize(solution.estimated_error());
  return static_cast<double>(solution.residuals().equation);
}

template <Real R>
void answer(benchmark::State& state, const ContactProblem& problem) {
  double residual = 0;
  for (auto _ : state) residual = ask(*riemann_hilbert<R>(problem).solution);
  state.counters["residual"] = residual;
}

/// If there is a closed form, `solve` uses it.
template <Real R>
void formula(benchmark::State& state, const ContactProblem& problem) {
  for (auto _ : state) benchmark::DoNotOptimize(ask(*closed_form<R>(problem).solution));
}

}  // namespace

int main(int argc, char** argv) {
  const auto add = [](const std::string& name, auto* run, const ContactProblem& problem) {
    benchmark::RegisterBenchmark(name.c_str(), run, problem)->Unit(benchmark::kMillisecond);
  };
  for (const auto& [name, problem] : problems()) {
    const std::string of = std::string(name) + ", ";
    add(of + "50 digits, bare", bare<Real50>, problem);
    add(of + "50 digits, answer", answer<Real50>, problem);
    add(of + "100 digits, bare", bare<Real100>, problem);
    add(of + "100 digits, answer", answer<Real100>, problem);
    if (!closed_form<double>(problem).solution) continue;
    add(of + "50 digits, answer by formula", formula<Real50>, problem);
    add(of + "100 digits, answer by formula", formula<Real100>, problem);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
