// Searches for several solutions of a contact problem, from different initial contact sets.

#include <algorithm>
#include <cmath>
#include <functional>
#include <future>
#include <mutex>
#include <numeric>
#include <random>
#include <thread>

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "numeric/variational/variational_solution.hpp"

namespace steadyslide::numeric {
namespace {

constexpr std::size_t start_cells = 64;

/// Returns start set `number`. Number 0 is the whole support; others have one to four contact zones of random lengths.
variational::CellSet start_set(int number, std::mt19937_64& random) {
  variational::CellSet set(start_cells, number == 0 ? 1 : 0);
  if (number == 0) return set;
  // Not a distribution of the standard library, because these differ between implementations.
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (std::size_t stretches = 1 + below(4); stretches-- > 0;) {
    const std::size_t from = below(start_cells);
    const std::size_t length = std::size_t{1} << below(6);
    for (std::size_t i = from; i < std::min(from + length, start_cells); ++i) set[i] = 1;
  }
  return set;
}

/// Returns int |t - t'| / P.
double difference(const VariationalSolution& a, const VariationalSolution& b) {
  const std::vector<double>& p = a.found().fine.found.state.pressure;
  const std::vector<double>& q = b.found().fine.found.state.pressure;
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += std::abs(p[i] - q[i]);
  return sum / static_cast<double>(p.size());
}

/// Returns the Riemann-Hilbert solution with the same contact; null if the search led to another contact.
std::shared_ptr<const ContactSolution<double>> refined(const ContactProblem& problem,
                                                       const VariationalSolution& rough) {
  if (may_have_many_gaps(problem)) return nullptr;
  const Attempt<double> attempt = riemann_hilbert<double>(problem, &rough);
  if (!attempt.solution || !attempt.solution->failed_condition().empty()) return nullptr;
  // The contacts agree within a few cells. This loose bound is sufficient, because different solutions are far apart.
  const Resultants<double> a = attempt.solution->resultants();
  const Resultants<double> b = rough.resultants();
  const auto& runs = rough.runs();
  const double span = rough.cell_length() * static_cast<double>(runs.back().end - runs.front().begin);
  const double error = rough.estimated_error().resultants + 8 * rough.cell_length() / span;
  for (std::size_t k = 0; k < a.load_share.size(); ++k) {
    if (std::abs(a.load_share[k].value - b.load_share[k].value) > error) return nullptr;
  }
  if (std::abs(a.centre_of_pressure.value - b.centre_of_pressure.value) > error * span) return nullptr;
  return attempt.solution;
}

bool same_ends(const ContactSolution<double>& a, const ContactSolution<double>& b) {
  const auto ends = a.contact();
  const auto others = b.contact();
  if (ends.size() != others.size()) return false;
  constexpr double rounding = 1e-9;
  const double length = ends.back().right.x.value - ends.front().left.x.value;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (std::abs(ends[k].left.x.value - others[k].left.x.value) > rounding * length) return false;
    if (std::abs(ends[k].right.x.value - others[k].right.x.value) > rounding * length) return false;
  }
  return true;
}

int different_refinements(const std::vector<FoundSolution>& solutions) {
  std::vector<const ContactSolution<double>*> different;
  for (const FoundSolution& found : solutions) {
    if (!found.refined) continue;
    const auto known = std::any_of(different.begin(), different.end(),
                                   [&](const auto* other) { return same_ends(*found.refined, *other); });
    if (!known) different.push_back(found.refined.get());
  }
  return static_cast<int>(different.size());
}

}  // namespace

SolutionSearch search_solutions(const ContactProblem& problem, int starts, const VariationalOptions& options,
                                std::uint64_t seed) {
  std::mt19937_64 random(seed);
  SolutionSearch search;
  struct Met {
    std::shared_ptr<const VariationalSolution> solution;
    int times;
  };
  std::vector<Met> met;
  const int together = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::mutex reporting;
  std::vector<std::size_t> done_by(static_cast<std::size_t>(starts), 0);
  for (int first = 0; first < starts; first += together) {
    // Solve in parallel on all cores. Results are taken in order, so the answer does not depend on the number of cores.
    std::vector<std::future<std::shared_ptr<const VariationalSolution>>> solved;
    for (int number = first; number < std::min(first + together, starts); ++number) {
      VariationalOptions each = options;
      each.friction_rule = variational::FrictionRule::galerkin;
      if (options.progress) {
        // Report the common progress of all searches, from any thread.
        each.progress = [&, number](std::size_t done, std::size_t total) {
          const std::lock_guard lock(reporting);
          done_by[static_cast<std::size_t>(number)] = done;
          options.progress(std::accumulate(done_by.begin(), done_by.end(), std::size_t{0}), done_by.size() * total);
        };
      }
      solved.push_back(std::async(std::launch::async, [&problem, each, set = start_set(number, random)] {
        return std::make_shared<const VariationalSolution>(problem, variational::solve_nested(problem, each, set));
      }));
    }
    for (auto& future : solved) {
      const std::shared_ptr<const VariationalSolution> solution = future.get();
      if (problem.elasticity().indenter() && solution->reaches_edge()) {
        search.reason = "the contact of an elastic indenter reaches an edge, where the half-plane idealisation fails";
        return search;
      }
      ++search.starts;
      if (!solution->failed_condition().empty()) {
        ++search.unsolved;
        continue;
      }
      const auto same = std::find_if(met.begin(), met.end(), [&](const Met& other) {
        const double allowed = std::max(0.01, solution->estimated_error().traction);
        return difference(*solution, *other.solution) <= allowed;
      });
      if (same != met.end()) {
        ++same->times;
      } else {
        met.push_back({solution, 1});
      }
    }
  }
  std::stable_sort(met.begin(), met.end(), [](const Met& a, const Met& b) { return a.times > b.times; });
  for (const Met& m : met) search.solutions.push_back({m.solution, refined(problem, *m.solution), m.times});
  search.refinements = different_refinements(search.solutions);
  return search;
}

}  // namespace steadyslide::numeric
