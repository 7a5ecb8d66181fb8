#include "proofs_checks/kit/registry.hpp"

#include <iterator>

#include "proofs_checks/claims/claims.hpp"

namespace steadyslide::proofs_checks {

const std::vector<Claim>& registry() {
  static const std::vector<Claim> all = [] {
    std::vector<Claim> claims;
    for (const auto make : {constants_claims,
                            surface_displacement_claims,
                            problem_claims,
                            elastic_indenter_claims,
                            flat_punch_claims,
                            friction_jump_claims,
                            paper_figure_claims,
                            parabola_claims,
                            words_claims,
                            outside_claims,
                            remark_claims,
                            bilinear_form_claims,
                            functional_claims,
                            dual_problem_claims,
                            plemelj_claims,
                            integral_claims,
                            local_action_claims,
                            proof_step_claims,
                            derivation_claims,
                            riemann_hilbert_claims,
                            contact_load_claims,
                            gap_claims,
                            linearisation_claims,
                            corner_claims,
                            end_claims,
                            convergence_claims,
                            cell_energy_claims,
                            cell_definiteness_claims,
                            cell_indefiniteness_claims,
                            cell_solution_claims,
                            cell_loading_claims,
                            beyond_calculation_claims}) {
      std::vector<Claim> some = make();
      std::move(some.begin(), some.end(), std::back_inserter(claims));
    }
    return claims;
  }();
  return all;
}

}  // namespace steadyslide::proofs_checks
