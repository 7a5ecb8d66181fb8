#include "numeric/variational/nested_solve.hpp"

#include <algorithm>

#include "numeric/variational/lemke.hpp"

namespace steadyslide::numeric::variational {
namespace {

constexpr std::size_t coarsest = 64;
constexpr std::size_t most_in_tableau = 512;
constexpr std::size_t most_contested = 256;

/// The cell of another uniform mesh in which the middle of cell i lies.
std::size_t coarse_cell(std::size_t i, std::size_t fine, std::size_t coarse) {
  return (2 * i + 1) * coarse / (2 * fine);
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

class Nested {
 public:
  Nested(const ContactProblem& problem, const NestedOptions& options)
      : problem_(problem), options_(options), sizes_(mesh_sizes(options.cells)) {
    for (const std::size_t n : sizes_) total_ += n;
  }

  NestedResult solve() {
    NestedResult result;
    for (const std::size_t n : sizes_) {
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
    MeshSolution solution{std::make_shared<DiscreteProblem>(problem_, CellMesh(problem_, n)), {}, false};
    CellSet start(n, 1);
    DiscreteState guess;
    guess.pressure.assign(n, 0);
    if (coarse.problem) {
      const std::size_t m = coarse.problem->size();
      start = prolonged(coarse.found.contact, n);
      guess = coarse.found.state;
      guess.pressure.resize(n);
      for (std::size_t i = 0; i < n; ++i) guess.pressure[i] = coarse.found.state.pressure[coarse_cell(i, n, m)];
    } else if (options_.start) {
      start = prolonged(*options_.start, n);
    }
    solution.found = active_set(*solution.problem, std::move(start), guess, active_set_options());
    if (solution.found.outcome != ActiveSetResult::Outcome::solved) go_on(solution);
    return solution;
  }

  /// Active sets that cycle: Lemke's method on the cells that could not decide, or on all of a small mesh; what it
  /// finds is where the active sets begin again.
  void go_on(MeshSolution& solution) {
    const DiscreteProblem& problem = *solution.problem;
    const std::size_t n = problem.size();
    if (n <= most_in_tableau) {
      const LemkeResult found = lemke(problem, static_cast<int>(20 * n));
      if (found.reached) accept(solution, found.contact, found.state);
      if (solved(solution)) return;
    }
    for (int attempt = 0; attempt < 3 && !solved(solution); ++attempt) {
      const std::vector<std::size_t> contested = solution.found.contested;
      if (contested.empty() || contested.size() > most_contested) return;
      const auto system = [&](const DiscreteProblem& p, const CellSet& contact) {
        const bool dense = n <= most_in_tableau;
        return dense ? dense_system(p, contact) : krylov_system(p, contact, solution.found.state, 1e-13);
      };
      const LemkeResult found = lemke_on(problem, solution.found.contact, contested, system, 4000);
      accept(solution, found.contact, found.state);
    }
  }

  void accept(MeshSolution& solution, const CellSet& contact, const DiscreteState& state) {
    ActiveSetResult again = active_set(*solution.problem, contact, state, active_set_options());
    again.steps += solution.found.steps;
    again.products += solution.found.products;
    if (again.outcome != ActiveSetResult::Outcome::solved && again.wrong >= solution.found.wrong) return;
    solution.found = std::move(again);
    solution.by_lemke = true;
  }

  static bool solved(const MeshSolution& solution) {
    return solution.found.outcome == ActiveSetResult::Outcome::solved;
  }

  ActiveSetOptions active_set_options() const {
    ActiveSetOptions options;
    options.most_steps = options_.most_steps;
    if (options_.progress) {
      options.after_step = [this](std::size_t) { options_.progress(done_, total_); };
    }
    return options;
  }

  const ContactProblem& problem_;
  const NestedOptions& options_;
  std::vector<std::size_t> sizes_;
  std::size_t done_ = 0;
  std::size_t total_ = 0;
};

}  // namespace

CellSet prolonged(const CellSet& set, std::size_t cells) {
  CellSet result(cells);
  for (std::size_t i = 0; i < cells; ++i) result[i] = set[coarse_cell(i, cells, set.size())];
  return result;
}

NestedResult solve_nested(const ContactProblem& problem, const NestedOptions& options) {
  return Nested(problem, options).solve();
}

}  // namespace steadyslide::numeric::variational
