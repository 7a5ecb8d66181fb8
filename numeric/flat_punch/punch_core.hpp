#pragma once
// Where the load may act on a flat punch that is free to tilt, so that it stays in full contact (the core of the contact,
// as that of a column's section). In y of friction_layout.hpp, with M_j there:
//
//   from M_1/(1+M_0) - (1+M_0)/2 to (1-M_0)/2 - M_1/(1-M_0);   without friction from -1/2 to 1/2.
//
// Derivation: a slope k of the punch adds a multiple of (1/Y) without its part that falls at infinity, and 1/Y = x + M_0 + ...:
// t = -t_0 (P + k (x + M_0)), int t = -P for every k. It is <= 0 all over if P + k (1 + M_0) >= 0 and P - k (1 - M_0) >= 0. The
// load acts at -M_0 + (k/P) V, V the variance of t_0: Y = 1/x - M_0/x^2 + (1/2 + M_0^2/2 - M_1)/x^3 has the moments of t_0, so
// V = (1 - M_0^2)/2 - M_1, and the two bounds of k give the two ends. In other words: the right end is the centroid of
// 1/2 - alpha plus half its integral, the left end that of 1/2 + alpha minus half its integral. Nothing cancels for large s.

#include <optional>

#include "model/contact_problem.hpp"
#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

template <Real R>
struct PunchCore {
  Estimate<R> left;
  Estimate<R> right;
};

/// In the user's x; the load itself does not matter. Absent unless the punch is rigid and its profile is constant.
template <Real R>
std::optional<PunchCore<R>> punch_core(const ContactProblem& problem);

}  // namespace steadyslide::numeric
