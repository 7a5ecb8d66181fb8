#pragma once
// The claims that share a source file with others.

#include <vector>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> bilinear_form_claims();
std::vector<Claim> constant_friction_claims();
std::vector<Claim> corner_claims();
std::vector<Claim> dual_problem_claims();
std::vector<Claim> end_claims();
std::vector<Claim> functional_claims();
std::vector<Claim> outside_claims();
std::vector<Claim> proof_step_claims();
std::vector<Claim> remark_claims();
std::vector<Claim> sign_form_claims();

inline std::vector<std::vector<Claim> (*)()> older_claims() {
  return {
      bilinear_form_claims,
      constant_friction_claims,
      corner_claims,
      dual_problem_claims,
      end_claims,
      functional_claims,
      outside_claims,
      proof_step_claims,
      remark_claims,
      sign_form_claims,
  };
}

}  // namespace steadyslide::proofs_checks
