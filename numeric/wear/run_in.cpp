#include "numeric/wear/run_in.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/variational/lemke.hpp"
#include "numeric/variational/nested_solve.hpp"

namespace steadyslide::numeric::wear {
namespace {

using variational::DiscreteProblem;

/// The load and the moment of the pressures max(A + B x, 0)/k, and their derivatives.
struct Carried {
  double load = 0, moment = 0;
  double load_a = 0, load_b = 0, moment_a = 0, moment_b = 0;

  Carried(const DiscreteProblem& problem, const std::vector<double>& k, double a, double b) {
    for (std::size_t i = 0; i < k.size(); ++i) {
      const double x = problem.place(i), centre = problem.mesh().centre(i);
      const double weight = problem.mesh().length(i) / k[i];
      if (a + b * x <= 0) continue;
      load += weight * (a + b * x);
      moment += weight * centre * (a + b * x);
      load_a += weight;
      load_b += weight * x;
      moment_a += weight * centre;
      moment_b += weight * centre * x;
    }
  }
};

std::optional<std::vector<double>> of_worn_cells(const DiscreteProblem& problem, const std::vector<double>& k) {
  double a = 1 / Carried(problem, k, 1, 0).load, b = 0;
  if (problem.load_at()) {
    // Newton's method, shortened where it does not approach: the pressures are piecewise linear in A and B.
    const auto miss = [&](const Carried& c) { return std::hypot(c.load - 1, c.moment - *problem.load_at()); };
    constexpr int most_steps = 200;
    Carried now(problem, k, a, b);
    for (int step = 0; miss(now) > 1e-14; ++step) {
      const double load = 1 - now.load, moment = *problem.load_at() - now.moment;
      const double determinant = now.load_a * now.moment_b - now.load_b * now.moment_a;
      double da = (load * now.moment_b - moment * now.load_b) / determinant;
      double db = (moment * now.load_a - load * now.moment_a) / determinant;
      const double before = miss(now);
      Carried next(problem, k, a + da, b + db);
      for (int half = 0; half < 40 && !(miss(next) < before); ++half) {
        da /= 2;
        db /= 2;
        next = Carried(problem, k, a + da, b + db);
      }
      if (!(miss(next) < before) || step == most_steps) {
        if (before > 1e-10) return std::nullopt;
        break;  // only rounding remains
      }
      a += da;
      b += db;
      now = next;
    }
  }
  std::vector<double> result(k.size());
  for (std::size_t i = 0; i < k.size(); ++i) result[i] = std::max(a + b * problem.place(i), 0.0) / k[i];
  return result;
}

/// Solves for contact on the cells with k = 0 alone: all others are lifted.
std::optional<std::vector<double>> of_lasting_cells(const DiscreteProblem& problem, const std::vector<double>& k) {
  const auto [low, high] = std::minmax_element(problem.profile().begin(), problem.profile().end());
  constexpr double far_away = 1e6;
  std::vector<double> lowered(k.size());
  variational::CellSet lasting(k.size());
  for (std::size_t i = 0; i < k.size(); ++i) {
    if (k[i] > 0) lowered[i] = -far_away * (1 + *high - *low);
    lasting[i] = k[i] == 0;
  }
  const auto alone = std::make_shared<const DiscreteProblem>(problem, lowered);
  const auto found = variational::solve_on_cells(alone, lasting, {std::vector<double>(k.size())}, {}).found;
  const double load_at = problem.load_at().value_or(0);
  double load = 0, moment = 0;
  for (std::size_t i = 0; i < k.size(); ++i) {
    if (k[i] > 0) continue;
    const double force = found.state.pressure[i] * problem.mesh().length(i);
    load += force;
    moment += force * problem.mesh().centre(i);
  }
  const bool fits = std::abs(load - 1) < 1e-8 && (!problem.load_at() || std::abs(moment - load_at) < 1e-8);
  if (found.outcome != variational::ActiveSetResult::Outcome::solved || !fits) return std::nullopt;
  return found.state.pressure;
}

}  // namespace

std::optional<std::vector<double>> run_in_pressure(const DiscreteProblem& problem, const std::vector<double>& k) {
  const bool all_wear = std::all_of(k.begin(), k.end(), [](double value) { return value > 0; });
  return all_wear ? of_worn_cells(problem, k) : of_lasting_cells(problem, k);
}

}  // namespace steadyslide::numeric::wear
