#pragma once
// All claims, in the paper's order.
//
// cmake/claims.cmake collects them from the folders of proofs_checks/claims. A claim `thm-03-outside-slope` is a
// function thm_03_outside_slope() in a source file of this name; its text is the Markdown file beside it. A text
// without a source is also a claim if it has a proof, lists decided statements, names a study of convergence or gives
// the reason why nothing can be calculated.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

struct ClaimEntry {
  std::string_view id;
  std::string_view group;  ///< its folder, "theorem-3"
  std::string_view document;
  Claim (*make)();
};

/// Makes the claim and returns it with its group, and with its proof if it has one.
Claim made(const ClaimEntry& entry);

/// Returns the claims that cmake/claims.cmake collected, in alphabetical order.
std::span<const ClaimEntry> claim_list();

const std::vector<Claim>& registry();

/// Returns the folders of claims in alphabetical order, one for each place in the paper: "theorem-3".
std::vector<std::string> groups();

/// Returns the claims of one group. Throws std::invalid_argument if there is no such group.
std::vector<Claim> claims_of_group(std::string_view group);

}  // namespace steadyslide::proofs_checks
