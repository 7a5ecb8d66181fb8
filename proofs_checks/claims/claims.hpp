#pragma once
// The claims that share a source file with others.

#include <vector>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> corner_claims();
std::vector<Claim> end_claims();
std::vector<Claim> outside_claims();
std::vector<Claim> proof_step_claims();

inline std::vector<std::vector<Claim> (*)()> older_claims() {
  return {
      corner_claims,
      end_claims,
      outside_claims,
      proof_step_claims,
  };
}

}  // namespace steadyslide::proofs_checks
