#include "numeric/variational/active_set.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/variational/contact_hull.hpp"

namespace steadyslide::numeric::variational {
namespace {

bool is_finite(const DiscreteState& state) {
  return std::isfinite(state.approach) && std::isfinite(state.tilt) &&
         std::all_of(state.pressure.begin(), state.pressure.end(), [](double p) { return std::isfinite(p); });
}

/// Cells under tension, and cells that penetrate by more than rounding.
std::vector<std::size_t> wrong_cells(const CellSet& contact, const DiscreteState& state,
                                     const std::vector<double>& gaps, double rounding) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < contact.size(); ++i) {
    if (contact[i] ? state.pressure[i] < 0 : gaps[i] < -rounding) result.push_back(i);
  }
  return result;
}

}  // namespace

ActiveSetResult active_set(const DiscreteProblem& problem, CellSet start, const DiscreteState& guess,
                           const ActiveSetOptions& options) {
  constexpr std::size_t few = 16;
  ActiveSetResult best;
  best.outcome = ActiveSetResult::Outcome::cycled;
  std::size_t fewest = problem.size() + 1;
  CellSet contact = std::move(start);
  DiscreteState state = guess;
  double tolerance = options.first_tolerance;
  int patience = options.patience;
  std::shared_ptr<ContactHull> hull;
  std::unique_ptr<BorderedSystem> system;  // of the contact, if that is unchanged
  while (true) {
    if (best.steps == options.most_steps) {
      best.outcome = ActiveSetResult::Outcome::out_of_steps;
      break;
    }
    ++best.steps;
    const double scale = height_over(problem, cells_of(contact));
    const bool again = system != nullptr;
    if (!again) {
      if (!problem.mesh().is_uniform() || cells_of(contact).size() <= options.dense_cells) {
        system = dense_system(problem, contact);
      } else {
        hull = contact_hull(problem, contact, std::move(hull));
        system = krylov_system(problem, contact, state, tolerance * scale, hull);
      }
    }
    SystemSolution solution = again ? system->refined(tolerance * scale) : solve(*system, problem);
    best.products += solution.products;
    if (!is_finite(solution.state)) break;  // one cell alone cannot carry a load at another place
    state = std::move(solution.state);
    const std::vector<double> gap = gaps(problem, state);
    std::vector<std::size_t> wrong = wrong_cells(contact, state, gap, 4 * options.tolerance * scale);
    if (options.after_step) options.after_step(wrong.size());

    const bool exact = solution.products == 0 || tolerance <= options.tolerance;
    if (wrong.size() < fewest || (wrong.empty() && exact)) {
      fewest = wrong.size();
      patience = options.patience;
      best.contact = contact;
      best.state = state;
      best.wrong = wrong;
    } else if (--patience < 0) {
      break;
    }
    if (wrong.empty() && exact) {
      best.outcome = ActiveSetResult::Outcome::solved;
      break;
    }
    // Few wrong cells: the end is near, and what is nearly solved decides wrongly.
    if (wrong.size() <= few) tolerance = options.tolerance;
    if (!wrong.empty()) system = nullptr;
    for (const std::size_t i : wrong) contact[i] = contact[i] ? 0 : 1;
    if (cells_of(contact).empty()) {
      // All are released: the lowest of them touches first.
      const auto lowest = std::min_element(wrong.begin(), wrong.end(), [&](std::size_t a, std::size_t b) {
        return problem.profile()[a] < problem.profile()[b];
      });
      contact[*lowest] = 1;
    }
  }
  if (best.contact.empty()) {
    best.contact = std::move(contact);
    best.state = std::move(state);
  }
  for (double& p : best.state.pressure) p = std::max(p, 0.0);
  return best;
}

}  // namespace steadyslide::numeric::variational
