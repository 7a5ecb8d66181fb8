#pragma once
// Solves for complementary pairs x_i >= 0, y_i >= 0, x_i y_i = 0 by interior points [CPS92, section 5.9]:
//
//   y = M x + r - c,   sum x = total,   or   y = M x + r.
//
// The method follows a path on which all products x_i y_i are equal and fall to zero. It has no contact set, drops no
// equation and solves for no basis at the end. Therefore it shares only M and r with active sets and pivots. In double.
// For the contact problem on cells x are the forces and y the gaps.

#include <optional>

#include "numeric/variational/nested_solve.hpp"
#include "proofs_checks/instruments/cells/cells.hpp"

namespace steadyslide::proofs_checks {

struct ComplementaryPair {
  Eigen::VectorXd x;
  Eigen::VectorXd y;
};

/// Returns the pair. Without `total` there is no c. Returns nothing if the path is lost; this happens only if M is not
/// positive semidefinite on the differences of admissible x.
std::optional<ComplementaryPair> by_interior_points(const Eigen::MatrixXd& m, const Eigen::VectorXd& r,
                                                    std::optional<double> total);

/// Returns the solutions that the active-set method finds from these contact sets; some sets may give none.
std::vector<DiscreteState> solutions_from(const DiscreteProblem& problem, const std::vector<CellSet>& starts);

/// Returns a problem with three solutions: s falls by 5 under a parabola on eight cells. Contact of the first cell is a
/// solution, contact of the first and fifth cells is another, and contact of these and the fourth cell is the third. A
/// claim solves it from every contact set.
ProblemOnCells problem_with_three_solutions();
std::vector<CellSet> all_contact_sets(std::size_t cells);
/// Returns a set of about half of the cells, at least one.
CellSet random_contact_set(Random& random, std::size_t cells);

/// Returns the forces p_i h_i.
Eigen::VectorXd forces_of(const DiscreteProblem& problem, const DiscreteState& state);
/// Returns the forces of the solution for an indenter that keeps its attitude. Returns nothing if the path is lost.
std::optional<Eigen::VectorXd> forces_by_interior_points(const DiscreteProblem& problem);
/// Returns the largest difference, divided by the largest component of a.
double difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

}  // namespace steadyslide::proofs_checks
