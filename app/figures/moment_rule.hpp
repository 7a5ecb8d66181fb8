#pragma once
// The equations of the Riemann-Hilbert method for one contact zone with two free ends, by Gauss-Jacobi rules of n nodes
// on every panel: with h = eps cos(pi alpha) (u'/c) / |Y|, u' the profile's slope,
//
//   int_K h dx = 0,   int_K x h dx = -c P   (lengths and slopes of the reduced problem).
//
// No panel is longer than its distance from the next singular point: Bernstein's ellipse through that point has the
// parameter 3 + sqrt 8 or more, and the error of n nodes falls at least like (3 + sqrt 8)^(-2n). [Bal16, theorem 36,
// reconstructed]

#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"

namespace steadyslide::app {

/// The relative errors of the two equations with n nodes.
struct MomentErrors {
  numeric::Real50 condition;  ///< |int h| / int |h|
  numeric::Real50 load;       ///< |int x h + c P| / (c P)
};

/// For a solved problem with one contact zone, free ends and no tilt. The ends are those of the solution.
MomentErrors moment_errors(const numeric::RiemannHilbertSolution<numeric::Real50>& solution, int nodes);

}  // namespace steadyslide::app
