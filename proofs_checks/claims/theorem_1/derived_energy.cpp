// The energy of a traction of zero mean. [Bal16, sections 3.1 and 4]

#include "proofs_checks/instruments/derived.hpp"
#include "symbolic/statements/energy_identity.hpp"

namespace steadyslide::proofs_checks {
namespace {

const std::vector<symbolic::DecidedStatement>& energies() {
  static const std::vector<symbolic::DecidedStatement> all = symbolic::energy_statements();
  return all;
}

}  // namespace

Claim derived_energy() {
  return derived(
      {"energy-identity", "[Bal16, sections 3.1 and 4]: the energy of a traction of zero mean",
       "`b(t, t) = -(1/pi) <<t * log|x|, t>> + (1/2) sum_k (s_k - s_{k-1}) T(c_k)^2`, `T(x) = int_{-1}^x t`: of the "
       "friction only its jumps are felt. One friction value gives a skew-symmetric form, and the logarithmic one is "
       "`(pi/2) sum_n a_n^2/n` for `t = sum_n a_n T_n(x)/sqrt(1-x^2)`, `T_n` Chebyshev's polynomials.",
       "`int t = 0`; `s` constant between its jumps. Decided for two jumps and piecewise polynomials, and for three "
       "jumps and `n <= 5`, with coefficients, frictions and places of the jumps as symbols.",
       "`T` vanishes at both ends, so that integration by parts gives `<<int_{-1}^x s t, t>> = -int s t T`, and `t T = "
       "(T^2)'/2`. Between two jumps `s` is constant and the integral is a difference of values of `T^2`; the sum over "
       "the panels leaves `(1/2) sum_k (s_k - s_{k-1}) T(c_k)^2`. The logarithm takes `T_n(x)/sqrt(1-x^2)` to `-(pi/n) "
       "T_n(x)`, and Chebyshev's polynomials are orthogonal with the weight `1/sqrt(1-x^2)`."},
      energies,
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
