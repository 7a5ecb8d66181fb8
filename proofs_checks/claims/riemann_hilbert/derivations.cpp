// The statements that the symbolic layer derives and decides: local forms, the Riemann-Hilbert problem, closed forms as
// theorems, the energy.

#include <iterator>

#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/derived.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> derivation_claims() {
  std::vector<Claim> claims = derived_local_forms();
  std::vector<Claim> some = derived_general_solution();
  std::move(some.begin(), some.end(), std::back_inserter(claims));
  claims.push_back(derived_energy());
  return claims;
}

}  // namespace steadyslide::proofs_checks
