#pragma once
// Random problems on cells, for claims about the discrete problem: support [-1, 1], gamma = 1/2 (f = 2 |s|), reduced
// quantities. All in double.

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

/// The values of s on the pieces, from left to right. All have the same sign, because there is one direction of
/// sliding.
struct CellFrictionSteps {
  std::vector<Rational> s;
  std::vector<Rational> jumps;
};

enum class Trend { rising, falling, any };
/// Returns 1 to `most_jumps` friction jumps with 0 <= s <= largest.
CellFrictionSteps random_steps(Random& random, Trend trend, const Rational& largest, std::size_t most_jumps);
/// Returns the steps for sliding towards -x: x -> -x and s -> -s. Rising steps stay rising.
CellFrictionSteps mirrored(const CellFrictionSteps& steps);

ContactProblem cell_problem(const CellFrictionSteps& steps, const Polynomial& profile = Polynomial(),
                            const Rational& load = 1, std::optional<Rational> load_at = std::nullopt);

/// Returns one piece, x^4 + (..) x^2 + ..., with one to three wells; `convex` gives one well.
Polynomial random_profile(Random& random, bool convex);

enum class Cells { equal, unequal, alternating, graded };
/// Returns a mesh. `unequal`: ratios of lengths up to 1:20. `alternating`: long and short cells in turn, 20:1.
/// `graded`: refined towards a friction jump, down to 1e-7; `count` is ignored.
CellMesh random_cells(Random& random, const ContactProblem& problem, Cells cells, std::size_t count);

struct ProblemOnCells {
  ContactProblem problem;
  CellMesh mesh;
};
/// Returns a problem with 0 <= |s| <= largest. The mesh is equal, unequal or graded, by the remainder of k; the first
/// two kinds have 16 to 39 cells. The profile has one well for even k. With `may_tilt`, about one indenter in four may
/// tilt.
ProblemOnCells random_problem_on_cells(Random& random, std::size_t k, Trend trend, const Rational& largest,
                                       bool may_tilt);
std::string text_of(const ProblemOnCells& on_cells);

/// Returns the operator; load and profile are not needed.
GalerkinOperator operator_of(const CellFrictionSteps& steps, const CellMesh& mesh);

/// Returns the symmetric part of B as a form of the forces q_i = t_i h_i: (B_ij/h_j + B_ji/h_i)/2. `slip` includes
/// friction.
Eigen::MatrixXd symmetric_part(const CellMesh& mesh, const GalerkinOperator& b, bool slip);
/// Returns B_ij/h_j: the gap in cell i under a unit force on cell j.
Eigen::MatrixXd gap_of_forces(const GalerkinOperator& b, const CellMesh& mesh);
/// Converts a form of forces into a form of the values of T at the inner cell ends, q_i = T_{i+1} - T_i: the form on
/// tractions of zero mean.
Eigen::MatrixXd on_zero_mean(const Eigen::MatrixXd& form);
/// Returns the weights in T(c) = weights . q: 1 for cells left of c, and for the cell with c the part left of c.
Eigen::VectorXd weights_of(const CellMesh& mesh, double c);

std::string text_of(const CellFrictionSteps& steps);

}  // namespace steadyslide::proofs_checks
