#include "symbolic/statements/energy_identity.hpp"
#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {
namespace {

const std::vector<symbolic::DecidedStatement>& energies() {
  static const std::vector<symbolic::DecidedStatement> all = symbolic::energy_statements();
  return all;
}

}  // namespace

Claim energy_identity() {
  return derived(
      "energy-identity", energies,
      {{"piecewise polynomials",
        {"energy-piecewise-polynomial"},
        {"without 1/2", "jumps of the other sign", "the sum for the difference", "T for T^2",
         "a mean that is not zero"}},
       {"two tractions",
        {"energy-bilinear"},
        {"1/2 of it", "the other sign", "the sum for the difference", "the difference of both orders", "one order"}},
       {"skew form", {"energy-skew"}, {"a mean that is not zero", "frictions that jump", "int s t t", "int s t^2 T"}},
       {"primitive", {"energy-chebyshev-primitive"}, {"the other sign", "without 1/n", "of T_(n+1)", "of U_n"}},
       {"Chebyshev's polynomials over a root",
        {"energy-chebyshev-friction"},
        {"without 1/2", "jumps of the other sign", "the sum for the difference", "T for T^2", "without 1-c^2"}},
       {"logarithmic form",
        {"energy-logarithmic-form"},
        {"pi sum a_n^2/n", "the other sign", "(pi/2) sum a_n^2/n^2", "(pi/2) sum n a_n^2", "(pi/2) sum a_n^2"}}});
}

}  // namespace steadyslide::proofs_checks
