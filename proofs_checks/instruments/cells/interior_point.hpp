#pragma once
// Complementary pairs x_i >= 0, y_i >= 0, x_i y_i = 0 by interior points [CPS92, section 5.9]:
//
//   y = M x + r - c,   sum x = total,   or   y = M x + r,
//
// along a path on which all products x_i y_i are equal and fall to nothing. There is no contact set, no equation is
// ever left out and no basis is solved for at the end: with active sets and pivots this route shares M, r and nothing
// else. In double. For the contact problem on cells x are the forces and y the gaps.

#include <optional>

#include "numeric/variational/nested_solve.hpp"
#include "proofs_checks/instruments/cells/cells.hpp"

namespace steadyslide::proofs_checks {

struct ComplementaryPair {
  Eigen::VectorXd x;
  Eigen::VectorXd y;
};

/// Without `total` there is no c. Nothing where the path is lost, which happens only if M is not positive semidefinite
/// on the differences of such x.
std::optional<ComplementaryPair> by_interior_points(const Eigen::MatrixXd& m, const Eigen::VectorXd& r,
                                                    std::optional<double> total);

/// The solutions that active sets find from these sets, where they do.
std::vector<DiscreteState> solutions_from(const DiscreteProblem& problem, const std::vector<CellSet>& starts);

/// s falls by 5 under a parabola on eight cells: complementary are the contacts of the first cell, of the first and the
/// fifth, and of these and the fourth. To be solved from every contact set.
ProblemOnCells problem_with_three_solutions();
std::vector<CellSet> all_contact_sets(std::size_t cells);
/// About half of the cells, at least one.
CellSet random_contact_set(Random& random, std::size_t cells);

/// p_i h_i.
Eigen::VectorXd forces_of(const DiscreteProblem& problem, const DiscreteState& state);
/// Those of the solution, the attitude given. Nothing where the path is lost.
std::optional<Eigen::VectorXd> forces_by_interior_points(const DiscreteProblem& problem);
/// The largest difference, over the largest force.
double difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

}  // namespace steadyslide::proofs_checks
