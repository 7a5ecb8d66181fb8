#include "proofs_checks/instruments/local_form_families.hpp"

#include "symbolic/statements/local_form_statements.hpp"

namespace steadyslide::proofs_checks {

const std::vector<symbolic::DecidedStatement>& decided_local_forms() {
  static const std::vector<symbolic::DecidedStatement> all = symbolic::local_form_statements();
  return all;
}

Family end_family(const std::string& theorem, bool free, bool two_frictions) {
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

Family wedge_family(std::vector<std::string> ids) {
  return {"wedge",
          std::move(ids),
          {"pi missing in the logarithm", "Heaviside's function on the other side", "the sign of alpha",
           "Heaviside's function missing", "1/(1+s^2) missing", "1/sqrt(1+s^2) in place of 1/(1+s^2)",
           "the slopes of the sides swapped", "a factor 2 in the logarithm"}};
}

}  // namespace steadyslide::proofs_checks
