// bench_cell_bounds PROBLEM CELLS...: the proved bounds of the first load share and of the effective friction for each
// number of cells, as rows of a Markdown table. The exit code is 1 if nothing is proved.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "enclosure/cells/cell_bound.hpp"
#include "library/problem_file/problem_file.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "numeric/variational/variational_solution.hpp"

namespace {

using namespace steadyslide;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

bool print_row(const ContactProblem& problem, std::size_t cells) {
  Clock::time_point start = Clock::now();
  const auto attempt = numeric::variational_inequality(problem, {.cells = cells});
  if (!attempt.solution) throw std::runtime_error(attempt.reason);
  const auto& solution = dynamic_cast<const numeric::VariationalSolution&>(*attempt.solution);
  const double solved = seconds_since(start);
  start = Clock::now();
  const std::vector<double> pressures = solution.touching_pressures();
  const double touching = seconds_since(start);
  start = Clock::now();
  const enclosure::CellBound bound = enclosure::bound_cells(problem, pressures);
  const double bounded = seconds_since(start);
  if (!bound.proved) {
    std::fprintf(stderr, "%zu cells: %s\n", cells, bound.reason.c_str());
    return false;
  }
  const enclosure::Ball& share = bound.load_share.front();
  std::printf("| %zu | %.2e | %.5f ± %.1e | %.5f ± %.1e | %.1f s | %.1f s | %.1f s |\n", cells,
              bound.energy.to_double(), share.to_double(), share.radius().to_double(),
              bound.effective_friction.to_double(), bound.effective_friction.radius().to_double(), solved, touching,
              bounded);
  std::fflush(stdout);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const ContactProblem problem = library::read_problem(argc > 1 ? argv[1] : "").contact;
    bool proved = true;
    for (int k = 2; k < argc; ++k) proved = print_row(problem, std::strtoul(argv[k], nullptr, 10)) && proved;
    return proved ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 2;
  }
}
