// Traction and slope next to one point, from the local equation. [Bal16, theorems 2, 3, 9, 10]

#include "proofs_checks/instruments/derived.hpp"
#include "symbolic/statements/local_form_statements.hpp"

namespace steadyslide::proofs_checks {
namespace {

const std::vector<symbolic::DecidedStatement>& local_forms() {
  static const std::vector<symbolic::DecidedStatement> all = symbolic::local_form_statements();
  return all;
}

Family ends(const std::string& theorem, bool free, bool two_frictions) {
  Family family{
      free ? "free end" : "edge",
      {theorem + (free ? "-free-" : "-edge-")},
      {"the sign of alpha: front and rear exchanged", "alpha missing in the power", "1/2 missing in the power",
       "sqrt(1+s^2) missing in the slope", "1/sqrt(1+s^2) in the slope", "the sign of the slope",
       "the power of the " + std::string(free ? "edge" : "free end") + " with this slope"}};
  if (two_frictions) {
    family.variants.emplace_back("the angle of the other side");
    family.variants.emplace_back("sqrt(1+s^2) of the other side in the slope");
  }
  return family;
}

Family wedge(std::vector<std::string> ids) {
  return {"wedge",
          std::move(ids),
          {"pi missing in the logarithm", "Heaviside's function on the other side", "the sign of alpha",
           "Heaviside's function missing", "1/(1+s^2) missing", "1/sqrt(1+s^2) in place of 1/(1+s^2)",
           "the slopes of the sides swapped", "a factor 2 in the logarithm"}};
}

Claim jumps_and_wedges() {
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
  return derived(claim_text("thm-02-local-forms"), local_forms, {jump, both, wedge({"theorem-2-wedge"})});
}

Claim contact_ends() {
  return derived(claim_text("thm-03-local-forms"), local_forms,
                 {ends("theorem-3", false, true), ends("theorem-3", true, true)});
}

Claim logarithm() {
  return derived(claim_text("thm-09-local-forms"), local_forms, {wedge({"theorem-9", "theorem-9-three-orders"})});
}

Claim one_friction() {
  return derived(claim_text("thm-10-local-forms"), local_forms,
                 {ends("theorem-10", false, false), ends("theorem-10", true, false)});
}

}  // namespace

std::vector<Claim> derived_local_forms() { return {jumps_and_wedges(), contact_ends(), logarithm(), one_friction()}; }

}  // namespace steadyslide::proofs_checks
