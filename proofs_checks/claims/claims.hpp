#pragma once
// The claims that share a source file with others.

#include <vector>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> outside_claims();
std::vector<Claim> riemann_hilbert_claims();
std::vector<Claim> contact_load_claims();
std::vector<Claim> gap_claims();
std::vector<Claim> linearisation_claims();
std::vector<Claim> corner_claims();
std::vector<Claim> end_claims();
std::vector<Claim> cell_energy_claims();
std::vector<Claim> cell_definiteness_claims();
std::vector<Claim> cell_indefiniteness_claims();
std::vector<Claim> cell_solution_claims();
std::vector<Claim> cell_loading_claims();
std::vector<Claim> proof_step_claims();
std::vector<Claim> words_claims();

inline std::vector<std::vector<Claim> (*)()> older_claims() {
  return {
      outside_claims,
      riemann_hilbert_claims,
      contact_load_claims,
      gap_claims,
      linearisation_claims,
      corner_claims,
      end_claims,
      cell_energy_claims,
      cell_definiteness_claims,
      cell_indefiniteness_claims,
      cell_solution_claims,
      cell_loading_claims,
      proof_step_claims,
      words_claims,
  };
}

}  // namespace steadyslide::proofs_checks
