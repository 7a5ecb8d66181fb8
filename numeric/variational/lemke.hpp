#pragma once
// The discrete contact problem by complementary pivots, for contacts on which active sets cycle.
//
// Unknown forces q_i = p_i h_i >= 0 and gaps g_i >= 0 with q_i g_i = 0. No entry of B is negative and no diagonal entry
// is zero, so q.Bq > 0 for every q >= 0 but 0, whatever the friction (B is strictly copositive).
//
// Attitude given. Let the approach be Lemke's artificial variable: g = psi + B q - approach. Far below the lowest psi
// there is no contact. From there the path of complementary pivots cannot come back, so it ends in a ray, with a
// direction q', g' >= 0, q'.g' = 0, g' = B q' - approach'. If q' were 0, it would be the ray it came from; so the load
// sum q goes to infinity, continuously, from 0. It passes through 1: a loading path, and a solution for every load.
//
// Load given. With sum q = 1 all along, let the tilt go from -infinity, where the last cell carries everything. In a
// ray sum q' = 0, so q' = 0, g' = tilt' xi - approach' >= 0 with g' = 0 where there is contact: contact in the first
// cell alone, tilt' > 0, or the ray it came from. So the tilt goes to +infinity and the centre of pressure from the
// last cell to the first one, both continuously: an indenter that rolls over the support. With load_at the path is left
// where the centre of pressure is there, if that lies between the centres of the outermost cells; else where the tilt
// is 0. It can be followed from the other side as well.
//
// These paths exist; how long they are is another matter. With s = 5 on cells from 1e-9 to 1/50 (a parabola) each of
// them takes more than 9000 pivots. Where one is long another may be short: the loading path and the rolling ones are
// followed by turns, with a number of pivots that grows from turn to turn. [CPS92, section 4.4], [Bal16, section 3.1]

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "numeric/variational/bordered_system.hpp"

namespace steadyslide::numeric::variational {

/// A flat face and equal minima touch everywhere at once; a slight curvature, the same every time, gives places an order.
double slight_curve(double x, double from, double to, double size);

/// Of an indenter that may tilt.
struct Levers {
  Eigen::VectorXd arm;    ///< the lever arms of forces about the load
  Eigen::VectorXd point;  ///< where the gaps are, which a tilt opens
  double width;           ///< of the support, for both
};

/// Where a path of pivots ended: reached, or in a ray, or with no pivot left.
struct PivotPath {
  CellSet contact;  ///< one entry for each pair of variables
  bool reached;
  int pivots;
};

/// The contact reached when the load grows from 0 to 1: at most one cell touches or leaves at a time. Where friction makes the
/// way turn, the load decreases again for a while. gaps = heights - approach + influence forces, and the moment about the load
/// stays zero where there are levers; `first` is the cell that touches first, or the two cells then.
PivotPath load_path(const Eigen::MatrixXd& influence, const Eigen::VectorXd& heights,
                    const std::vector<std::size_t>& first, const std::optional<Levers>& levers, int most_pivots);

struct LemkeResult {
  CellSet contact;
  DiscreteState state;
  int pivots = 0;
  /// The set is complementary: natural_residual() is below complementary_within.
  bool reached = false;
};

/// Natural residuals up to this one are rounding errors, in units of P/unit and c P.
inline constexpr double complementary_within = 1e-8;

/// max_i |min(p_i, g_i)|: zero for a solution and for nothing else, given the loads. Over all cells, or over some.
double natural_residual(const DiscreteProblem& problem, const DiscreteState& state);
double natural_residual(const DiscreteProblem& problem, const DiscreteState& state,
                        const std::vector<std::size_t>& cells);

/// Makes the system of a contact set; the problem outlives it.
using BorderedSystemMaker =
    std::function<std::unique_ptr<BorderedSystem>(const DiscreteProblem& problem, const CellSet& contact)>;

/// The whole mesh in one tableau: n^2 numbers, 2 n^2 operations a pivot, most often fewer than n pivots. `most_pivots`
/// is for all paths together; 20 n is enough for all of the 2000 random problems of the tests' list, n = 128 and 256.
LemkeResult lemke(const DiscreteProblem& problem, int most_pivots);

/// The same with a gap everywhere but on `cells`, which increase: what holds for the whole matrix holds for theirs.
/// reached: these cells are complementary; whether others penetrate is for the caller to see.
LemkeResult lemke_among(const DiscreteProblem& problem, const std::vector<std::size_t>& cells, int most_pivots);

/// Only the contested cells may change, the others are in contact or not as `contact` says. One solution with the
/// contact set less the contested cells for each contested cell, then Lemke's method on the Schur complement, with the
/// covering vector of ones. That matrix need not be copositive: the path may end in a ray, then reached = false and
/// `contact` is what was certain. Where what is certain cannot bear the load alone: lemke_among() all of these cells.
/// reached: the contested cells are complementary; whether the others are is for the caller to see.
LemkeResult lemke_on(const DiscreteProblem& problem, const CellSet& contact, const std::vector<std::size_t>& contested,
                     const BorderedSystemMaker& bordered_system, int most_pivots);

}  // namespace steadyslide::numeric::variational
