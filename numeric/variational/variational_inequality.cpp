#include "numeric/variational/variational_inequality.hpp"

#include <stdexcept>

#include "numeric/variational/variational_solution.hpp"

namespace steadyslide::numeric {

Attempt<double> variational_inequality(const ContactProblem& problem, const VariationalOptions& options) {
  if (options.cells < fewest_cells || options.cells > most_cells) throw std::invalid_argument("number of cells");
  variational::NestedOptions nested;
  nested.cells = options.cells;
  nested.most_steps = options.most_steps;
  nested.progress = options.progress;
  auto solution = std::make_shared<VariationalSolution>(problem, variational::solve_nested(problem, nested));
  if (problem.elasticity().indenter() && solution->reaches_edge()) {
    return {nullptr, "the contact of an elastic indenter reaches an edge, where the half-plane idealisation fails"};
  }
  return {std::move(solution), {}};
}

}  // namespace steadyslide::numeric
