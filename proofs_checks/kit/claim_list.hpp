#pragma once
// What the folders of proofs_checks/claims hold, collected by cmake/claims.cmake: a claim `thm-03-outside-slope` is a
// function thm_03_outside_slope() in a source file of this name, its text in the Markdown file beside it. A text alone
// is a claim, too, if it lists decided statements, names a study of convergence or says why nothing can be calculated.

#include <span>
#include <string_view>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

struct ClaimEntry {
  std::string_view id;
  std::string_view group;  ///< the folder, "theorem-3"
  std::string_view document;
  Claim (*make)();
};

/// In alphabetical order.
std::span<const ClaimEntry> claim_list();

}  // namespace steadyslide::proofs_checks
