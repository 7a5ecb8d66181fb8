#pragma once
// Krawczyk's operator: for a box V, its centre v, F and an approximate inverse C of F'(v),
//
//   K(V) = v - C F(v) + (1 - C F'(V)) (V - v);
//
// if K(V) lies inside the interior of V, there is exactly one zero of F in V. For an interval of loads with the middle
// load p, F is taken at (v, p), F' for all loads, and -C dF/dP (P - p) is added. Then there is exactly one zero for
// each load.

#include "checker/conditions.hpp"

namespace steadyslide::checker {

struct Krawczyk {
  Box image;               ///< the loads and the contact of the box, with K(V) in place of V; contains the zero
  slong bits = 0;          ///< precision of F(v)
  double contraction = 0;  ///< the largest radius of K(V) relative to that of V
};

/// Returns K(V) from F(v) at the middle load and from the derivative over V and P: a row for each condition, a column
/// for each unknown and one for the load. `loads` is P - p. Throws Unproved if the derivative's centre has no inverse.
std::vector<Ball> krawczyk_image(const std::vector<Ball>& V, const std::vector<Ball>& F,
                                 const std::vector<std::vector<Ball>>& derivative, const Ball& loads, slong precision);

/// Proves a zero. Throws Unproved with the unknown that leaves its box.
Krawczyk prove_zero(const ReducedProblem& problem, const Box& box, slong least_precision);

}  // namespace steadyslide::checker
