#pragma once
// Every claim, in the paper's order.

#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

const std::vector<Claim>& registry();

/// The folders of claims, one for each place in the paper, alphabetically: "theorem-3".
std::vector<std::string> groups();

/// The claims of one of them. Throws std::invalid_argument if there is none of this name.
std::vector<Claim> claims_of_group(std::string_view group);

}  // namespace steadyslide::proofs_checks
