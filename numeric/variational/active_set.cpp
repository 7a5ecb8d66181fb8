#include "numeric/variational/active_set.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace steadyslide::numeric::variational {
namespace {

/// How wrong cells are: tension in units of P/(support), penetration in units of c P, and nothing below rounding.
struct Violations {
  std::vector<std::size_t> cells;
  std::vector<double> sizes;
};

Violations violations(const CellSet& contact, const DiscreteState& state, const std::vector<double>& gaps,
                      double rounding) {
  Violations result;
  for (std::size_t i = 0; i < contact.size(); ++i) {
    const double size = contact[i] ? -state.pressure[i] : -gaps[i];
    if (size <= (contact[i] ? 0 : rounding)) continue;
    result.cells.push_back(i);
    result.sizes.push_back(size);
  }
  return result;
}

std::size_t hash_of(const CellSet& set) {
  std::size_t hash = 1469598103934665603u;
  for (const char cell : set) hash = (hash ^ static_cast<unsigned char>(cell)) * 1099511628211u;
  return hash;
}

/// The height of the profile over the contact set: what rounding of the gaps is relative to.
double height(const DiscreteProblem& problem, const CellSet& contact) {
  double low = 0;
  double high = 0;
  bool first = true;
  for (std::size_t i = 0; i < contact.size(); ++i) {
    if (!contact[i]) continue;
    const double psi = problem.profile()[i];
    low = first ? psi : std::min(low, psi);
    high = first ? psi : std::max(high, psi);
    first = false;
  }
  return std::max(1.0, high - low);
}

SystemSolution solve_set(const DiscreteProblem& problem, const CellSet& contact, const DiscreteState& guess,
                         double tolerance, std::size_t dense_cells) {
  const auto cells = static_cast<std::size_t>(std::count(contact.begin(), contact.end(), 1));
  const bool dense = !problem.mesh().is_uniform() || cells <= dense_cells;
  const auto system = dense ? dense_system(problem, contact) : krylov_system(problem, contact, guess, tolerance);
  return solve(*system, problem);
}

}  // namespace

ActiveSetResult active_set(const DiscreteProblem& problem, CellSet start, const DiscreteState& guess,
                           const ActiveSetOptions& options) {
  ActiveSetResult best;
  best.wrong = problem.size() + 1;
  CellSet contact = std::move(start);
  DiscreteState state = guess;
  std::set<std::size_t> seen;
  constexpr double loose = 1e-5;
  double tolerance = loose;
  int products = 0;
  // As long as the number of wrong cells falls now and then, all are changed; after that one at a time, the worst one.
  constexpr int most_patience = 10;
  int patience = most_patience;
  std::size_t fewest = problem.size() + 1;
  std::vector<int> last_wrong(problem.size(), 0);  // the step in which a cell was wrong last
  for (int step = 1; step <= options.most_steps; ++step) {
    const double scale = height(problem, contact);
    SystemSolution solution =
        solve_set(problem, contact, state, std::max(tolerance, options.tolerance) * scale, options.dense_cells);
    products += solution.products;
    state = std::move(solution.state);
    std::vector<double> gap = gaps(problem, state);
    const Violations wrong = violations(contact, state, gap, 4 * options.tolerance * scale);
    if (options.after_step) options.after_step(wrong.cells.size());
    const bool exact = solution.products == 0 || tolerance <= options.tolerance;
    if (wrong.cells.size() < best.wrong || (exact && wrong.cells.empty())) {
      best = {
          ActiveSetResult::Outcome::out_of_steps, contact, state, std::move(gap), wrong.cells.size(), step, products};
    }
    best.steps = step;
    best.products = products;
    if (wrong.cells.empty()) {
      if (exact) {
        best.outcome = ActiveSetResult::Outcome::solved;
        break;
      }
      tolerance = options.tolerance;
      continue;
    }
    for (const std::size_t i : wrong.cells) last_wrong[i] = step;
    if (wrong.cells.size() < fewest) {
      fewest = wrong.cells.size();
      patience = most_patience;
    } else if (patience > 0) {
      --patience;
    }
    const bool one_by_one = patience == 0;
    if (!seen.insert(hash_of(contact)).second && one_by_one && exact) {
      best.outcome = ActiveSetResult::Outcome::cycled;
      break;
    }
    // Few wrong cells: the end is near, and what is nearly solved decides wrongly.
    if (wrong.cells.size() <= 16 || one_by_one) tolerance = options.tolerance;
    if (one_by_one) {
      const auto worst = std::max_element(wrong.sizes.begin(), wrong.sizes.end());
      char& cell = contact[wrong.cells[static_cast<std::size_t>(worst - wrong.sizes.begin())]];
      cell = cell ? 0 : 1;
    } else {
      for (const std::size_t i : wrong.cells) contact[i] = contact[i] ? 0 : 1;
    }
    if (std::none_of(contact.begin(), contact.end(), [](char c) { return c != 0; })) {
      // All released: the one that is pressed least away.
      const auto lowest = std::min_element(best.gaps.begin(), best.gaps.end());
      contact[static_cast<std::size_t>(lowest - best.gaps.begin())] = 1;
    }
  }
  for (double& p : best.state.pressure) p = std::max(p, 0.0);
  if (best.outcome != ActiveSetResult::Outcome::solved) {
    for (std::size_t i = 0; i < last_wrong.size(); ++i) {
      if (last_wrong[i] > 0 && last_wrong[i] + 2 * most_patience >= best.steps) best.contested.push_back(i);
    }
  }
  return best;
}

}  // namespace steadyslide::numeric::variational
