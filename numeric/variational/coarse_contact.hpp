#pragma once
// A coarse solution that locates the contact. It is a small variational solution without singular functions: piecewise
// constant traction on cells that are divided at every friction jump and break of the profile, and Galerkin's equations
// with the kernel of
//
//   u(x)/c = -(1/pi) int t(x') log|x - x'| dx' + int_left^x s t,      u/c + C <= psi/c, t <= 0, t (u/c + C - psi/c) = 0
//
// at one point of each cell, int t = -P. The solver is an active-set method with dense LU. Cells are refined where
// contact may begin or end, until every contact component has several cells. [Bal16, section 3.1]

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "model/contact_problem.hpp"
#include "numeric/number/polynomial.hpp"
#include "numeric/solution/contact_interval.hpp"
#include "numeric/variational/surface_kernel.hpp"

namespace steadyslide::numeric {

/// Lengths are measured from `origin`, which is exact.
struct CoarseContact {
  Rational origin;
  std::vector<ContactInterval> zones;  ///< left to right
  double tilt = 0;                     ///< slope added to psi/c; 0 without load_at
  std::vector<double> cell_edges;      ///< edges of the last mesh
  std::vector<double> traction;        ///< one per cell
  bool converged = true;               ///< false: the active sets cycled; the best one is given
};

/// Returns the coarse solution. The first mesh has about `cells` cells, the last one at most 16 times as many.
CoarseContact coarse_contact(const ContactProblem& problem, int cells);

namespace coarse {

// The cells of the coarse solution. Each has one friction value and one piece of the profile. The effect of forces on
// the gap at the points of all cells is
//
//   gap_i = psi_i - C + tilt x_i + sum_j G_ij q_j,   G_ij = mean_j k(x_i - x') + int_left^{x_i} s over cell j,
//
// with the kernel k and the force q_j >= 0 on cell j, uniformly distributed. The point x_i divides its cell in the
// ratio 1/2 + alpha : 1/2 - alpha. With the mean over the cell, or its centre, cells next to a concentrated force would
// oscillate and lose contact under strong friction (s > 2, say), as the trapezoidal rule does for a stiff equation. For
// s -> +-infinity this point gives the implicit Euler rule.

/// The part of the support between two neighbouring friction jumps or breaks of the profile. Lengths are measured from
/// the origin.
struct SupportPiece {
  double left;
  double right;
  double s;
  double ahead;                 ///< 1/2 + alpha, the fraction of a cell left of its point
  double behind;                ///< 1/2 - alpha, the fraction right of it, computed without subtraction
  std::vector<double> profile;  ///< psi/c, coefficients of 1, x, x^2, ...
  int step;                     ///< the sign of psi(x+) - psi(x-) at `left`

  double profile_at(double x) const { return value_of(profile, x); }
};

class Mesh {
 public:
  /// Makes about `cells` cells of similar length, at least two for each piece if the cost allows it.
  Mesh(const ContactProblem& problem, const Rational& origin, int cells, const variational::SurfaceKernel& kernel = {});
  /// Returns the mesh with every cell divided into pieces[i] >= 1 equal parts.
  Mesh refined(const std::vector<int>& pieces) const;

  std::size_t size() const { return piece_of_.size(); }
  const std::vector<double>& edges() const { return edges_; }
  double left(std::size_t i) const { return edges_[i]; }
  double right(std::size_t i) const { return edges_[i + 1]; }
  double length(std::size_t i) const { return edges_[i + 1] - edges_[i]; }
  double centre(std::size_t i) const { return (edges_[i] + edges_[i + 1]) / 2; }
  const SupportPiece& piece(std::size_t i) const { return pieces_[piece_of_[i]]; }
  /// Returns the point of cell i: the centre without friction, close to the right end for s -> inf.
  double point(std::size_t i) const { return edges_[i] + piece(i).ahead * length(i); }
  /// Returns psi/c at that point.
  double profile(std::size_t i) const { return piece(i).profile_at(point(i)); }
  /// Returns G_ij for all i. It is computed at first use, because most cells never carry a force.
  const Eigen::VectorXd& column(std::size_t j) const;
  /// True if the cell is the first or the last one of its piece.
  bool beside_cut(std::size_t i) const;
  /// Returns the sign of the step at the left end of cell i; 0 inside a piece.
  int step_before(std::size_t i) const;

 private:
  Mesh() = default;

  variational::SurfaceKernel kernel_;
  std::vector<SupportPiece> pieces_;
  std::vector<double> edges_;
  std::vector<std::size_t> piece_of_;
  mutable std::vector<Eigen::VectorXd> columns_;
};

// Contact on a fixed mesh: q >= 0, gap >= 0, q gap = 0 cell by cell, sum q = P, and with a load line sum q x = P x0.

struct Load {
  double force;
  std::optional<double> at;  ///< place of the load, from the origin; present if the indenter may tilt
};

struct Equilibrium {
  std::vector<char> active;
  std::vector<double> force;  ///< q
  std::vector<double> gap;
  double tilt = 0;
  double violation = 0;  ///< the largest force or gap of the wrong sign, divided by P
  bool converged = false;
};

/// Returns forces and gaps for a given contact set, with any signs. They are not finite if the equations are singular.
Equilibrium with_contact_on(const Mesh& mesh, const Load& load, const std::vector<char>& active);

/// Returns the contact set that is reached when the load grows from zero, by Lemke's pivots (lemke.hpp). Forces with a
/// given sum are a bounded set, so for any matrix the path cannot end before the given load. Empty if rounding stops
/// the path.
std::vector<char> load_path(const Mesh& mesh, const Load& load);

}  // namespace coarse
}  // namespace steadyslide::numeric
