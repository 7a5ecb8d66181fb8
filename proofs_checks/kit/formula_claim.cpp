#include "proofs_checks/kit/formula_claim.hpp"

namespace steadyslide::proofs_checks {
namespace {

std::vector<Evidence> examine(const FormulaCheck& check, const Context& asked, const FormulaCheck::Change& change) {
  const Context context{digits_at(check.precision, asked), asked.seed, asked.quick};
  const Number step = numeric::at_precision(context.digits, []<numeric::Real R>() { return Number(near_miss<R>()); });
  return gather([&] {
    Findings findings;
    const Examples examples = check.cases(context);
    for (const ExaminedCase& c : examples.cases) {
      findings.begin_case(c.where, c.effective);
      check.examine(findings, c.data.get(), context, change, step);
    }
    return findings.evidence(examples.detail);
  });
}

}  // namespace

Claim claim_of(FormulaCheck check) {
  const auto shared = std::make_shared<const FormulaCheck>(std::move(check));
  Claim claim{claim_text(shared->id), {}, {}};
  claim.examine = [shared](const Context& context) { return examine(*shared, context, {}); };
  for (const auto& [name, change] : shared->wrong) {
    claim.controls.push_back(
        {name, [shared, &change = change](const Context& context) { return examine(*shared, context, change); }});
  }
  return claim;
}

}  // namespace steadyslide::proofs_checks
