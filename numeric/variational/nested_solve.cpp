#include "numeric/variational/nested_solve.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "numeric/variational/lemke.hpp"

namespace steadyslide::numeric::variational {
namespace {

constexpr std::size_t coarsest = 64;
constexpr std::size_t most_in_tableau = 1024;
constexpr std::size_t tableau_work = 20'000'000'000;  // numbers changed by pivots: half a minute
constexpr std::size_t most_contested = 512;
constexpr std::size_t most_factorised = 2000;  // for many right-hand sides
constexpr int most_rounds = 30;
constexpr std::size_t most_coarser = 3;

/// The cell of another uniform mesh in which the middle of cell i lies.
std::size_t coarse_cell(std::size_t i, std::size_t fine, std::size_t coarse) {
  return (2 * i + 1) * coarse / (2 * fine);
}

/// The contact that a mesh of twice the cells is likely to have. Towards a free end the square of the pressure falls along a
/// line: how much of the last cell it ends behind is between nothing, where that cell is about to be released, and 0.8, where
/// the next one is about to touch. Of ends at random places a third is released by one of the smaller cells and a sixth goes on
/// by one: the limits are where so many lie.
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

/// n/2^k cells, rounded up, coarsest first; two at least: the error is seen by comparison.
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

/// Which cells are wrong in what Lemke's method has found?
void inspect(MeshSolution& solution, const LemkeResult& found, ActiveSetOptions options) {
  options.most_steps = 1;
  options.first_tolerance = options.tolerance;
  ActiveSetResult again = active_set(*solution.problem, found.contact, found.state, options);
  again.steps += solution.found.steps;
  again.products += solution.found.products;
  solution.found = std::move(again);
  solution.by_lemke = true;
}

/// Where the active sets cycle, Lemke's method decides: on all of a small mesh, or on the cells that are wrong, and
/// on those that this turns wrong, until there are none.
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
    // A path that did not end where nothing else is in contact leaves no state to go on from.
    if (found.state.pressure.empty()) return;
    inspect(solution, found, options);
  }
}

class Nested {
 public:
  Nested(const ContactProblem& problem, const VariationalOptions& options, const std::optional<CellSet>& start)
      : problem_(problem),
        profile_(problem, CellMesh(problem, 1).frame()),
        options_(options),
        start_(start),
        sizes_(mesh_sizes(options.cells)) {
    for (const std::size_t n : sizes_) total_ += n;
  }

  NestedResult solve() {
    NestedResult result;
    for (const std::size_t n : sizes_) {
      if (result.coarse.problem) result.coarser.insert(result.coarser.begin(), std::move(result.coarse.found.state));
      if (result.coarser.size() > most_coarser) result.coarser.pop_back();
      result.coarse = std::move(result.fine);
      result.fine = solve_on(n, result.coarse);
      done_ += n;
      if (options_.progress) options_.progress(done_, total_);
    }
    if (!result.coarse.problem) result.coarse = result.fine;
    result.certificate = certify(*result.fine.problem, result.fine.found.state);
    return result;
  }

 private:
  MeshSolution solve_on(std::size_t n, const MeshSolution& coarse) {
    auto problem = std::make_shared<DiscreteProblem>(problem_, CellMesh(problem_, n), profile_, options_.friction_rule);
    CellSet start(n, 1);
    DiscreteState guess;
    guess.pressure.assign(n, 0);
    if (coarse.problem) {
      const std::size_t m = coarse.problem->size();
      start = refined_contact(coarse, n);
      guess = coarse.found.state;
      guess.pressure.resize(n);
      for (std::size_t i = 0; i < n; ++i) guess.pressure[i] = coarse.found.state.pressure[coarse_cell(i, n, m)];
    } else if (start_) {
      start = prolonged(*start_, n);
    }
    return solve_on_cells(std::move(problem), std::move(start), guess, active_set_options(n));
  }

  ActiveSetOptions active_set_options(std::size_t n) const {
    ActiveSetOptions options;
    // Behind a free end the gap grows as the 3/2-th power of the distance; what is less right than that within a cell takes
    // in or releases wrong cells.
    options.first_tolerance = std::max(0.05 * std::pow(static_cast<double>(n), -1.5), options.tolerance);
    options.most_steps = options_.most_steps;
    if (options_.progress) {
      options.after_step = [this](std::size_t) { options_.progress(done_, total_); };
    }
    return options;
  }

  const ContactProblem& problem_;
  CellProfile profile_;
  const VariationalOptions& options_;
  const std::optional<CellSet>& start_;
  std::vector<std::size_t> sizes_;
  std::size_t done_ = 0;
  std::size_t total_ = 0;
};

}  // namespace

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

NestedResult solve_nested(const ContactProblem& problem, const VariationalOptions& options,
                          const std::optional<CellSet>& start) {
  return Nested(problem, options, start).solve();
}

}  // namespace steadyslide::numeric::variational
