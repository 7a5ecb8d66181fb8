#pragma once
// The claims that share a source file with others.

#include <vector>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> constants_claims();
std::vector<Claim> elastic_indenter_claims();
std::vector<Claim> friction_jump_claims();
std::vector<Claim> parabola_claims();
std::vector<Claim> integral_claims();
std::vector<Claim> derived_tractions();
std::vector<Claim> riemann_hilbert_claims();
std::vector<Claim> contact_load_claims();
std::vector<Claim> gap_claims();
std::vector<Claim> linearisation_claims();
std::vector<Claim> cell_energy_claims();
std::vector<Claim> cell_definiteness_claims();
std::vector<Claim> cell_indefiniteness_claims();
std::vector<Claim> cell_solution_claims();
std::vector<Claim> cell_loading_claims();
std::vector<Claim> paper_figure_claims();
std::vector<Claim> remark_claims();
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
      integral_claims,
      derived_tractions,
      riemann_hilbert_claims,
      contact_load_claims,
      gap_claims,
      linearisation_claims,
      cell_energy_claims,
      cell_definiteness_claims,
      cell_indefiniteness_claims,
      cell_solution_claims,
      cell_loading_claims,
      paper_figure_claims,
      remark_claims,
      dual_problem_claims,
      functional_claims,
      bilinear_form_claims,
      problem_claims,
      surface_displacement_claims,
  };
}

}  // namespace steadyslide::proofs_checks
