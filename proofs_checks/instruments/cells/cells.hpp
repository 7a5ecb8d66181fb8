#pragma once
// Random problems on cells, for what is claimed of the discrete problem: support [-1, 1], gamma = 1/2 (f = 2 |s|),
// reduced quantities. All in double.

#include <Eigen/Core>
#include <string>

#include "numeric/variational/discrete_problem.hpp"
#include "proofs_checks/kit/numbers.hpp"
#include "proofs_checks/kit/random.hpp"

namespace steadyslide::proofs_checks {

using numeric::variational::CellMesh;
using numeric::variational::CellSet;
using numeric::variational::DiscreteProblem;
using numeric::variational::DiscreteState;
using numeric::variational::GalerkinOperator;

/// s on its pieces, left to right; all of one sign, as one direction of sliding has it.
struct CellFrictionSteps {
  std::vector<Rational> s;
  std::vector<Rational> jumps;
};

enum class Trend { rising, falling, any };
/// 1 to `most_jumps` jumps, 0 <= s <= largest.
CellFrictionSteps random_steps(Random& random, Trend trend, const Rational& largest, std::size_t most_jumps);
/// The same, sliding towards -x: x -> -x and s -> -s. What rises goes on rising.
CellFrictionSteps mirrored(const CellFrictionSteps& steps);

ContactProblem cell_problem(const CellFrictionSteps& steps, const Polynomial& profile = Polynomial(),
                            const Rational& load = 1, std::optional<Rational> load_at = std::nullopt);

/// One piece, x^4 + (..) x^2 + ...: one to three wells, `convex` with one.
Polynomial random_profile(Random& random, bool convex);

enum class Cells { equal, unequal, alternating, graded };
/// `unequal`: lengths in ratios up to 1:20. `alternating`: long and short by turns, 20:1. `graded`: towards a friction
/// jump, down to 1e-7; `count` is not looked at.
CellMesh random_cells(Random& random, const ContactProblem& problem, Cells cells, std::size_t count);

struct ProblemOnCells {
  ContactProblem problem;
  CellMesh mesh;
};
/// 16 to 39 cells, by k's remainder equal, unequal or graded; 0 <= |s| <= largest, a profile with one well for even k.
/// One in four may tilt, or none.
ProblemOnCells random_problem_on_cells(Random& random, std::size_t k, Trend trend, const Rational& largest,
                                       bool may_tilt);
std::string text_of(const ProblemOnCells& on_cells);

/// Without load and profile.
GalerkinOperator operator_of(const CellFrictionSteps& steps, const CellMesh& mesh);

/// The symmetric part of B as a form of forces q_i = t_i h_i: (B_ij/h_j + B_ji/h_i)/2; `slip`: with friction.
Eigen::MatrixXd symmetric_part(const CellMesh& mesh, const GalerkinOperator& b, bool slip);
/// B_ij/h_j: the gap in cell i of a unit force on cell j.
Eigen::MatrixXd gap_of_forces(const GalerkinOperator& b, const CellMesh& mesh);
/// A form of forces as one of T at the cells' inner ends, q_i = T_{i+1} - T_i: on tractions of zero mean.
Eigen::MatrixXd on_zero_mean(const Eigen::MatrixXd& form);
/// The values T(c) = weights . q takes: 1 for cells left of c, the part that is left of c for its own.
Eigen::VectorXd weights_of(const CellMesh& mesh, double c);

std::string text_of(const CellFrictionSteps& steps);

}  // namespace steadyslide::proofs_checks
