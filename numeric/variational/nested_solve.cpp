#include "numeric/variational/nested_solve.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "numeric/variational/lemke.hpp"

namespace steadyslide::numeric::variational {
namespace {

constexpr std::size_t coarsest = 64;
constexpr std::size_t most_in_tableau = 1024;
constexpr std::size_t tableau_work = 20'000'000'000;  // numbers that pivots change: half a minute
constexpr std::size_t most_contested = 512;
constexpr std::size_t most_factorised = 2000;  // if there are many right-hand sides
constexpr int most_rounds = 30;
constexpr std::size_t most_coarser = 3;

/// Returns the cell of another uniform mesh that contains the middle of cell i.
std::size_t coarse_cell(std::size_t i, std::size_t fine, std::size_t coarse) {
  return (2 * i + 1) * coarse / (2 * fine);
}

/// Returns the likely contact on a mesh with twice as many cells. Towards a free end the square of the pressure
/// decreases linearly. The distance of the zero of this line from the middle of the last cell is between 0, if that
/// cell is about to be released, and 0.8 cell lengths, if the next one is about to touch. For ends at random places, a
/// third of them lose one of the smaller cells and a sixth gain one; the limits are set to these shares.
CellSet refined_contact(const MeshSolution& coarse, std::size_t cells) {
  const CellSet& contact = coarse.found.contact;
  const std::vector<double>& p = coarse.found.state.pressure;
  const auto m = static_cast<std::ptrdiff_t>(contact.size());
  const auto is_contact = [&](std::ptrdiff_t i) { return i >= 0 && i < m && contact[static_cast<std::size_t>(i)]; };
  CellSet result = prolonged(contact, cells);
  if (cells != 2 * contact.size()) return result;
  for (std::ptrdiff_t i = 0; i < m; ++i) {
    for (const std::ptrdiff_t out : {-1, 1}) {
      if (!is_contact(i) || is_contact(i + out) || !is_contact(i - out)) continue;
      const double last = p[static_cast<std::size_t>(i)];
      const double before = p[static_cast<std::size_t>(i - out)];
      if (last >= before) continue;
      const double part = last * last / (before * before - last * last);
      const std::ptrdiff_t end = 2 * i + (out + 1) / 2;
      if (part < 0.08) result[static_cast<std::size_t>(end)] = 0;
      if (part > 0.7 && end + out >= 0 && end + out < 2 * m) result[static_cast<std::size_t>(end + out)] = 1;
    }
  }
  return result;
}

/// Returns n/2^k cells, rounded up, coarsest first. There are at least two meshes, because their comparison gives the
/// error.
std::vector<std::size_t> mesh_sizes(std::size_t cells) {
  std::vector<std::size_t> sizes{cells};
  while (sizes.size() < 2 || sizes.back() > coarsest) {
    if (sizes.back() == 1) break;
    sizes.push_back((sizes.back() + 1) / 2);
  }
  std::reverse(sizes.begin(), sizes.end());
  return sizes;
}

bool solved(const MeshSolution& solution) { return solution.found.outcome == ActiveSetResult::Outcome::solved; }

/// Finds the wrong cells in the result of Lemke's method.
void inspect(MeshSolution& solution, const LemkeResult& found, ActiveSetOptions options) {
  options.most_steps = 1;
  options.first_tolerance = options.tolerance;
  ActiveSetResult again = active_set(*solution.problem, found.contact, found.state, options);
  again.steps += solution.found.steps;
  again.products += solution.found.products;
  solution.found = std::move(again);
  solution.by_lemke = true;
}

/// If the active sets cycle, Lemke's method continues: on the whole of a small mesh, or on the cells that are wrong and
/// on cells that become wrong, until there are none.
void go_on(MeshSolution& solution, const ActiveSetOptions& options) {
  const DiscreteProblem& problem = *solution.problem;
  const std::size_t n = problem.size();
  if (n <= most_in_tableau) {
    const LemkeResult found = lemke(problem, static_cast<int>(std::min(200 * n, tableau_work / (n * n))));
    if (found.reached) inspect(solution, found, options);
    return;
  }
  const BorderedSystemMaker system = [&](const DiscreteProblem& p, const CellSet& contact) {
    return cells_of(contact).size() <= most_factorised ? dense_system(p, contact)
                                                       : krylov_system(p, contact, solution.found.state, 1e-13);
  };
  std::set<std::size_t> contested;
  for (int round = 0; round < most_rounds && !solved(solution); ++round) {
    contested.insert(solution.found.wrong.begin(), solution.found.wrong.end());
    if (contested.size() > most_contested) return;
    const LemkeResult found = lemke_on(problem, solution.found.contact, {contested.begin(), contested.end()}, system,
                                       static_cast<int>(100 + 20 * contested.size()));
    // If the path did not reach its end and nothing else is in contact, there is no state to continue from.
    if (found.state.pressure.empty()) return;
    inspect(solution, found, options);
  }
}

bool is_finite(const DiscreteState& state) {
  return std::isfinite(state.approach) && std::isfinite(state.tilt) &&
         std::all_of(state.pressure.begin(), state.pressure.end(), [](double p) { return std::isfinite(p); });
}

/// Returns the cells under tension, and the cells whose penetration exceeds rounding.
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
  std::unique_ptr<BorderedSystem> system;  // of the contact, if the contact has not changed
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
    if (!is_finite(solution.state)) break;  // a single cell cannot carry a load at another place
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
    // With few wrong cells the search is nearly finished, and inaccurate equations would give wrong decisions.
    if (wrong.size() <= few) tolerance = options.tolerance;
    if (!wrong.empty()) system = nullptr;
    for (const std::size_t i : wrong) contact[i] = contact[i] ? 0 : 1;
    if (cells_of(contact).empty()) {
      // If all cells are released, the lowest of them touches first.
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

MeshSolution solve_on_cells(std::shared_ptr<const DiscreteProblem> problem, CellSet start, const DiscreteState& guess,
                            const ActiveSetOptions& options) {
  MeshSolution solution{std::move(problem), {}, false};
  solution.found = active_set(*solution.problem, std::move(start), guess, options);
  if (solution.found.outcome == ActiveSetResult::Outcome::cycled) go_on(solution, options);
  return solution;
}

CellSet prolonged(const CellSet& set, std::size_t cells) {
  CellSet result(cells);
  for (std::size_t i = 0; i < cells; ++i) result[i] = set[coarse_cell(i, cells, set.size())];
  return result;
}

NestedResult solve_nested(const ContactProblem& problem, const Frame& frame, const VariationalOptions& options) {
  const CellProfile profile(problem, frame);
  const SurfaceKernel kernel = surface_kernel(problem, frame);
  const std::vector<std::size_t> sizes = mesh_sizes(options.cells);
  const std::size_t total = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  std::size_t done = 0;
  const auto report = [&] {
    if (options.progress) options.progress(done, total);
  };
  NestedResult result;
  for (const std::size_t n : sizes) {
    if (result.coarse.problem) result.coarser.insert(result.coarser.begin(), std::move(result.coarse.found.state));
    if (result.coarser.size() > most_coarser) result.coarser.pop_back();
    result.coarse = std::move(result.fine);
    const MeshSolution& coarse = result.coarse;

    ActiveSetOptions on_mesh;
    // Behind a free end the gap grows like the 3/2-th power of the distance. A larger error within a cell would add or
    // release wrong cells.
    on_mesh.first_tolerance = std::max(0.05 * std::pow(static_cast<double>(n), -1.5), on_mesh.tolerance);
    on_mesh.most_steps = options.most_steps;
    on_mesh.after_step = [&](std::size_t) { report(); };
    CellSet contact(n, 1);
    DiscreteState guess{std::vector<double>(n)};
    if (coarse.problem) {
      contact = refined_contact(coarse, n);
      guess = coarse.found.state;
      guess.pressure.resize(n);
      for (std::size_t i = 0; i < n; ++i) {
        guess.pressure[i] = coarse.found.state.pressure[coarse_cell(i, n, coarse.problem->size())];
      }
    }
    auto on_cells =
        std::make_shared<DiscreteProblem>(problem, CellMesh(frame, n), profile, options.friction_rule, kernel);
    result.fine = solve_on_cells(std::move(on_cells), std::move(contact), guess, on_mesh);
    done += n;
    report();
  }
  if (!result.coarse.problem) result.coarse = result.fine;
  result.certificate = certify(*result.fine.problem, result.fine.found.state);
  return result;
}

}  // namespace steadyslide::numeric::variational
