#pragma once
// Solves the discrete contact problem by complementary pivots. For contacts on which active sets cycle.
//
// Unknown forces q_i = p_i h_i >= 0 and gaps g_i >= 0 with q_i g_i = 0. No entry of B is negative and no diagonal entry
// is zero. So q.Bq > 0 for every q >= 0 except 0, for any friction (B is strictly copositive).
//
// Given tilt. Let the approach be Lemke's artificial variable: g = psi + B q - approach. Far below the lowest psi there
// is no contact. From there the path of complementary pivots cannot return, so it ends in a ray, with a direction q',
// g' >= 0, q'.g' = 0, g' = B q' - approach'. If q' were 0, it would be the ray at the start. So the load sum q grows
// continuously from 0 to infinity and passes through 1. This is a loading path, and there is a solution for every load.
//
// Given load. With sum q = 1 on the whole path, let the tilt start from -infinity, where the last cell carries all
// load. In a ray sum q' = 0, so q' = 0, g' = tilt' xi - approach' >= 0 with g' = 0 where there is contact. This is
// contact in the first cell only, tilt' > 0, or the ray at the start. So the tilt goes to +infinity and the centre of
// pressure from the last cell to the first one, both continuously: the indenter rolls over the support. With load_at
// the path stops where the centre of pressure is there, if this is between the centres of the outermost cells. Without
// load_at it stops where the tilt is 0. The path can also start from the other side.
//
// These paths exist, but they may be long. With s = 5 on cells from 1e-9 to 1/50 (a parabola) each of them takes more
// than 9000 pivots. If one is long, another may be short. So the loading path and the rolling paths are followed in
// turn, with a limit of pivots that grows from turn to turn. [CPS92, section 4.4], [Bal16, section 3.1]

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "numeric/variational/bordered_system.hpp"

namespace steadyslide::numeric::variational {

/// Returns a slight curvature, always the same one. A flat face or equal minima would touch everywhere at once; the
/// curvature gives the places an order.
double slight_curve(double x, double from, double to, double size);

/// The levers of an indenter that may tilt.
struct Levers {
  Eigen::VectorXd arm;    ///< the lever arms of forces about the load
  Eigen::VectorXd point;  ///< the places of the gaps, which a tilt opens
  double width;           ///< width of the support, for both
};

/// The end of a path of pivots: the target is reached, or the path is a ray, or there is no pivot.
struct PivotPath {
  CellSet contact;  ///< one entry for each pair of variables
  bool reached;
  int pivots;
};

/// Returns the contact that is reached when the load grows from 0 to 1. At most one cell touches or leaves at a time.
/// If friction makes the path turn, the load decreases for a while. gaps = heights - approach + influence forces. With
/// levers, the moment about the load stays zero. `first` is the cell that touches first; with levers the two cells.
PivotPath load_path(const Eigen::MatrixXd& influence, const Eigen::VectorXd& heights,
                    const std::vector<std::size_t>& first, const std::optional<Levers>& levers, int most_pivots);

struct LemkeResult {
  CellSet contact;
  DiscreteState state;
  int pivots = 0;
  /// True if the set is complementary: natural_residual() is below complementary_within.
  bool reached = false;
};

/// Natural residuals up to this limit are rounding errors, in units of P/unit and c P.
inline constexpr double complementary_within = 1e-8;

/// Returns max_i |min(p_i, g_i)| over all or some cells. For given loads it is zero if and only if the state is a
/// solution.
double natural_residual(const DiscreteProblem& problem, const DiscreteState& state);
double natural_residual(const DiscreteProblem& problem, const DiscreteState& state,
                        const std::vector<std::size_t>& cells);

/// Makes the system of a contact set. The problem must outlive it.
using BorderedSystemMaker =
    std::function<std::unique_ptr<BorderedSystem>(const DiscreteProblem& problem, const CellSet& contact)>;

/// Solves the whole mesh in one tableau: n^2 numbers, 2 n^2 operations for each pivot, mostly fewer than n pivots.
/// `most_pivots` is the limit for all paths together; 20 n is sufficient for all 2000 random problems of the tests'
/// list, n = 128 and 256.
LemkeResult lemke(const DiscreteProblem& problem, int most_pivots);

/// The same with a gap outside `cells`, which are in increasing order. Properties of the whole matrix also hold for
/// theirs. `reached` means that these cells are complementary. The caller must check if others penetrate.
LemkeResult lemke_among(const DiscreteProblem& problem, const std::vector<std::size_t>& cells, int most_pivots);

/// Only the contested cells may change; `contact` is fixed for the others. The method solves the system of the certain
/// contact (the contact set without the contested cells) once for each contested cell. Then it applies Lemke's method
/// to the Schur complement, with a covering vector of ones. This matrix may not be copositive. So the path may end in a
/// ray; then reached = false and `contact` is the certain contact. If the certain contact cannot carry the load alone,
/// it calls lemke_among() for all these cells. `reached` means that the contested cells are complementary. The caller
/// must check the others.
LemkeResult lemke_on(const DiscreteProblem& problem, const CellSet& contact, const std::vector<std::size_t>& contested,
                     const BorderedSystemMaker& bordered_system, int most_pivots);

}  // namespace steadyslide::numeric::variational
