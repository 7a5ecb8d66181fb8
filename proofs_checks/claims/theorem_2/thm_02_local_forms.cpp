#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim thm_02_local_forms() {
  const Family jump{
      "friction jump",
      {"theorem-2-jump"},
      {"beta of the other sign: front and rear exchanged", "alpha_l + alpha_r in place of beta",
       "amplitudes of the sides swapped", "1/sqrt(1+s^2) missing", "sqrt(1+s^2) in place of its reciprocal",
       "the sign of one amplitude", "|x|^(beta+1) with amplitudes of one sign", "1/2 added to beta"}};
  const Family both{"wedge and friction jump",
                    {"theorem-2-wedge-and-jump"},
                    {"[s] taken from right to left", "s_l + s_r in place of [s]",
                     "the constant on the right side alone", "a factor pi in the constant",
                     "the constant without its divisor", "the constant missing", "a logarithm with the constant"}};
  return derived("thm-02-local-forms", decided_local_forms, {jump, both, wedge_family({"theorem-2-wedge"})});
}

}  // namespace steadyslide::proofs_checks
