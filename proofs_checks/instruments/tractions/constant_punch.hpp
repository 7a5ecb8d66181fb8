#pragma once
// The traction size cos(pi alpha)/pi (1+x)^{-(1/2+alpha)} (1-x)^{-(1/2-alpha)} in A t = 0 and in int t. For the punch
// under its load size = -P, [Bal16, (4)]; for t_0 size = 1, [Bal16, (8)].

#include <string>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

enum class PunchLoad { given, minus_one };

Claim constant_punch_claim(std::string id, PunchLoad load);

}  // namespace steadyslide::proofs_checks
