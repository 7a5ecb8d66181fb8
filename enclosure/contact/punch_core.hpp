#pragma once
// The core of a rigid flat punch that is free to tilt: if the load acts there, the punch stays in full contact. With y
// from -1 to 1 over the support, alpha = arctan(s)/pi and M_j = int y^j alpha dy, the core is
//
//   from M_1/(1+M_0) - (1+M_0)/2 to (1-M_0)/2 - M_1/(1-M_0).
//
// (The traction is -t_0 (P + k (y + M_0)) for a slope k, the variance of t_0 is (1 - M_0^2)/2 - M_1; t <= 0 at both
// ends gives the bounds of k.) All quantities are finite sums; |M_0| < 1.

#include <optional>

#include "enclosure/number/ball.hpp"
#include "model/contact_problem.hpp"

namespace steadyslide::enclosure {

struct PunchCore {
  Ball left;
  Ball right;
};

/// Returns the core in the user's x. Absent unless the punch is rigid and its profile is constant.
std::optional<PunchCore> punch_core(const ContactProblem& problem, Bits bits);

}  // namespace steadyslide::enclosure
