#pragma once
// Every claim, in the paper's order.
//
// They are what the folders of proofs_checks/claims hold, collected by cmake/claims.cmake: a claim `thm-03-outside-slope`
// is a function thm_03_outside_slope() in a source file of this name, its text in the Markdown file beside it. A text
// alone is a claim, too, if it has a proof, lists decided statements, names a study of convergence or says why nothing can be
// calculated.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

struct ClaimEntry {
  std::string_view id;
  std::string_view group;  ///< the folder, "theorem-3"
  std::string_view document;
  Claim (*make)();
};

/// Made anew, with its group, and with its proof if it has one.
Claim made(const ClaimEntry& entry);

/// What cmake/claims.cmake has collected, in alphabetical order.
std::span<const ClaimEntry> claim_list();

const std::vector<Claim>& registry();

/// The folders of claims, one for each place in the paper, alphabetically: "theorem-3".
std::vector<std::string> groups();

/// The claims of one of them. Throws std::invalid_argument if there is none of this name.
std::vector<Claim> claims_of_group(std::string_view group);

}  // namespace steadyslide::proofs_checks
