#pragma once
// The claims that share a source file with others.

#include <vector>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> constants_claims();
std::vector<Claim> elastic_indenter_claims();
std::vector<Claim> friction_jump_claims();
std::vector<Claim> parabola_claims();
std::vector<Claim> outside_claims();
std::vector<Claim> integral_claims();
std::vector<Claim> derived_tractions();
std::vector<Claim> corner_claims();
std::vector<Claim> end_claims();
std::vector<Claim> proof_step_claims();
std::vector<Claim> paper_figure_claims();
std::vector<Claim> remark_claims();
std::vector<Claim> words_claims();
std::vector<Claim> dual_problem_claims();
std::vector<Claim> functional_claims();
std::vector<Claim> bilinear_form_claims();
std::vector<Claim> problem_claims();
std::vector<Claim> surface_displacement_claims();

inline std::vector<std::vector<Claim> (*)()> older_claims() {
  return {
      constants_claims,
      elastic_indenter_claims,
      friction_jump_claims,
      parabola_claims,
      outside_claims,
      integral_claims,
      derived_tractions,
      corner_claims,
      end_claims,
      proof_step_claims,
      paper_figure_claims,
      remark_claims,
      words_claims,
      dual_problem_claims,
      functional_claims,
      bilinear_form_claims,
      problem_claims,
      surface_displacement_claims,
  };
}

}  // namespace steadyslide::proofs_checks
