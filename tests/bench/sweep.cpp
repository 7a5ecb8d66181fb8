// The cost of a sweep compared with its solves: bench_sweep SWEEP.toml [JOBS]. The measurements alternate, so that the
// load of the machine affects all of them: the numbers that solve prints, the same as texts, the rows of the table;
// then all solves, and all rows, in threads. Problems and texts are made in 20 blocks.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <thread>
#include <vector>

#include "app/sweep/ordered_tasks.hpp"
#include "app/sweep/sweep_table.hpp"
#include "numeric/closed_form/closed_form.hpp"

using namespace steadyslide;
using namespace steadyslide::app;

namespace {

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <class Act>
double time_of(double (*seconds)(), Act act) {
  const double start = seconds();
  act();
  return seconds() - start;
}

/// Computes the values that solve needs from a solution in double.
void numbers(const ContactProblem& problem) {
  const auto solution = numeric::closed_form<double>(problem).solution;
  if (!solution) return;
  const volatile double all[] = {solution->contact().front().left.x.value,
                                 solution->singular_points().front().intensity.value,
                                 solution->resultants().effective_friction.value, solution->estimated_error().traction,
                                 solution->residuals().equation};
  static_cast<void>(all);
}

}  // namespace

int main(int argc, char** argv) {
  const char* const file = argc > 1 ? argv[1] : "examples/sweep_two_coatings.toml";
  const SweepTable table(read_sweep(file));
  const Combinations problems = read_sweep(file).problems;
  constexpr std::size_t blocks = 20;
  double made = 0;
  double numeric = 0;
  double solved = 0;
  double rows = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    std::vector<Problem> list;
    made += time_of(cpu_seconds, [&] {
      for (std::size_t n = block; n < table.size(); n += blocks) list.push_back(problems.problem(n));
    });
    numeric += time_of(cpu_seconds, [&] {
      for (const Problem& problem : list) numbers(problem.contact);
    });
    solved += time_of(cpu_seconds, [&] {
      for (const Problem& problem : list) Solver({}).solve(problem);
    });
    rows += time_of(cpu_seconds, [&] {
      for (std::size_t n = block; n < table.size(); n += blocks) static_cast<void>(table.row(n));
    });
  }
  const int jobs = argc > 2 ? std::atoi(argv[2]) : 2;
  std::vector<Problem> all;
  for (std::size_t n = 0; n < table.size(); ++n) all.push_back(problems.problem(n));
  // Cores that work at the same time are slower. So the reference is all threads with parts of the bare solves.
  const double bare = time_of(clock_seconds, [&] {
    std::vector<std::jthread> threads;
    for (int k = 0; k < jobs; ++k) {
      threads.emplace_back([&, first = static_cast<std::size_t>(k)] {
        for (std::size_t n = first; n < all.size(); n += static_cast<std::size_t>(jobs)) Solver({}).solve(all[n]);
      });
    }
  });
  std::size_t bytes = 0;
  double threads = 0;
  const double wall = time_of(clock_seconds, [&] {
    threads = time_of(cpu_seconds, [&] {
      in_order(
          {0, table.size()}, jobs, [&](std::size_t n) { return table.row(n); },
          [&](std::size_t, const std::string& row) { bytes += row.size(); });
    });
  });
  const auto each = [&](double seconds) { return 1e6 * seconds / static_cast<double>(table.size()); };
  std::printf("%zu problems, CPU time of each in microseconds\n", table.size());
  std::printf("  problem made      %8.1f\n", each(made));
  std::printf("  numbers           %8.1f\n", each(numeric));
  std::printf("  solved            %8.1f\n", each(solved));
  std::printf("  row               %8.1f   / solved = %.3f\n", each(rows), rows / solved);
  std::printf("  row, in %d threads %8.1f   / solved = %.3f; on the clock %.2f s, x %d / solved = %.3f\n", jobs,
              each(threads), threads / solved, wall, jobs, wall * jobs / solved);
  std::printf("  bare solves, in %d threads: on the clock %.2f s, x %d / solved = %.3f; rows / these = %.3f\n", jobs,
              bare, jobs, bare * jobs / solved, wall / bare);
}
