#include "proofs_checks/kit/claim_builder.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

namespace steadyslide::proofs_checks {
namespace {

/// A claim that remembers its cases, so that what is kept for a case serves all controls.
class Runner {
 public:
  explicit Runner(ExaminedClaim claim) : claim_(std::move(claim)) {}

  const ExaminedClaim& claim() const { return claim_; }

  std::vector<Evidence> examine(const Context& asked, const ExaminedClaim::Change& change, const CaseSource& source) {
    const Context context{digits_at(claim_.precision, asked), asked.seed, asked.quick};
    const auto [tolerance_there, step] = numeric::at_precision(
        context.digits, []<numeric::Real R>() { return std::pair(tolerance<R>(), Number(near_miss<R>())); });
    return gather([&] {
      const Examples& examples = examples_of(source, context);
      Findings findings(quantities_of(claim_, tolerance_there));
      for (const ExaminedCase& c : examples.cases) {
        findings.begin_case(c.where, !claim_.effective || claim_.effective(c.data.get()));
        claim_.examine(findings, c.data.get(), context, change, step);
      }
      return findings.evidence(examples.detail);
    });
  }

 private:
  const Examples& examples_of(const CaseSource& source, const Context& context) {
    const auto [found, is_new] = examples_.try_emplace({&source, context.digits, context.seed, context.quick});
    if (is_new) found->second = source(context);
    return found->second;
  }

  ExaminedClaim claim_;
  std::map<std::tuple<const CaseSource*, numeric::Digits, std::uint64_t, bool>, Examples> examples_;
};

}  // namespace

std::vector<NamedQuantity> quantities_of(const ExaminedClaim& claim, double tolerance) {
  std::vector<NamedQuantity> all;
  for (const auto& [name, what, routes, how] : claim_text(claim.id).compared) {
    all.push_back(
        {name,
         {what, routes, how.tolerance != 0 ? how.tolerance : tolerance, how.required, how.absolute, how.at_most}});
  }
  return all;
}

Claim claim_of(ExaminedClaim examined) {
  const auto runner = std::make_shared<Runner>(std::move(examined));
  Claim claim{claim_text(runner->claim().id), {}, {}};
  const CaseSource& cases = runner->claim().cases;
  claim.examine = [runner, &cases](const Context& context) { return runner->examine(context, {}, cases); };
  for (const ExaminedClaim::Variant& control : runner->claim().controls) {
    claim.controls.push_back({control.name, [runner, &control, &cases](const Context& context) {
                                return runner->examine(context, control.change, control.cases ? control.cases : cases);
                              }});
  }
  return claim;
}

}  // namespace steadyslide::proofs_checks
