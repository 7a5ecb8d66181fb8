#include "proofs_checks/kit/claim_builder.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace steadyslide::proofs_checks {
namespace {

/// Changes the predicted value of one quantity by the smallest amount that a check must notice.
void miss(Values& predicted, const Quantity& quantity, const Number& precision_step) {
  const std::string& name = quantity.name;
  const Number step = quantity.tolerance != 0 ? Number(10 * quantity.tolerance) : precision_step;
  const Value* value = predicted.find(name);
  if (!value) return;
  if (const auto* number = std::get_if<Number>(value)) {
    predicted.set(name, quantity.absolute ? Number(*number + step) : Number(*number * (1 + step)));
  } else if (const auto* order = std::get_if<Order>(value)) {
    predicted.set(name, Order{order->rate + 2 * quantity.tolerance});
  } else if (const auto* exponent = std::get_if<Exponent>(value)) {
    predicted.set(name, *exponent + Exponent::angle(tiny()));
  } else if (const auto* rational = std::get_if<Rational>(value)) {
    predicted.set(name, Rational(*rational + tiny()));
  }
}

void compare(Findings& findings, const Quantity& quantity, const Value& measured, const Value& predicted) {
  const std::string& name = quantity.name;
  if (const auto* order = std::get_if<Order>(&measured)) {
    findings.measure({quantity.what, order->rate, order->error_bar, std::get<Order>(predicted).rate, quantity.tolerance,
                      order->detail});
  } else if (const auto* fit = std::get_if<Fitted>(&measured)) {
    const auto expected = static_cast<double>(std::get<Number>(predicted));
    findings.compare(name, fit->value / fit->error_bar, expected / fit->error_bar, 1);
  } else if (const auto* number = std::get_if<Number>(&measured)) {
    findings.compare(name, *number, std::get<Number>(predicted));
  } else {
    findings.decide(quantity.what, measured == predicted);
  }
}

/// A claim with its cases, which are made once. Therefore results kept for a case serve all controls.
class Runner {
 public:
  explicit Runner(ExaminedClaim claim) : claim_(std::move(claim)), text_(claim_text(claim_.id)) {}

  const ExaminedClaim& claim() const { return claim_; }
  const ClaimText& text() const { return text_; }

  std::vector<Evidence> examine(const Context& asked, const ExaminedClaim::Change& change, const CaseSource& source) {
    const Context context{digits_at(claim_.precision, asked), asked.seed, asked.quick};
    const auto [tolerance_there, step] = numeric::at_precision(
        context.digits, []<numeric::Real R>() { return std::pair(tolerance<R>(), Number(near_miss<R>())); });
    return gather([&, tolerance_there = tolerance_there, step = step] {
      const Examples& examples = examples_of(source, context);
      std::vector<Quantity> quantities = text_.compared;
      for (Quantity& quantity : quantities) {
        if (quantity.tolerance == 0) quantity.tolerance = tolerance_there;
      }
      Findings findings(std::move(quantities));
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
  ClaimText text_;
  std::map<std::tuple<const CaseSource*, numeric::Digits, std::uint64_t, bool>, Examples> examples_;
};

}  // namespace

Claim claim_of(ExaminedClaim examined) {
  const auto runner = std::make_shared<Runner>(std::move(examined));
  Claim claim{runner->text(), {}, {}};
  const CaseSource& cases = runner->claim().cases;
  claim.examine = [runner, &cases](const Context& context) { return runner->examine(context, {}, cases); };
  for (const ExaminedClaim::Variant& control : runner->claim().controls) {
    claim.controls.push_back({control.name, [runner, &control, &cases](const Context& context) {
                                return runner->examine(context, control.change, control.cases ? control.cases : cases);
                              }});
  }
  return claim;
}

void compare(Findings& findings, const Values& measured, const Values& predicted) {
  for (const Values* values : {&measured, &predicted}) {
    for (const Values::Named& named : *values) findings.quantity(named.name);
  }
  for (const Quantity& quantity : findings.quantities()) {
    const Value* a = measured.find(quantity.name);
    const Value* b = predicted.find(quantity.name);
    if (a && b) {
      compare(findings, quantity, *a, *b);
    } else if (a || b) {  // neither: this case does not have the quantity
      findings.skip(quantity);
    }
  }
}

void add_near_misses(ExaminedClaim& claim) {
  for (const Quantity& quantity : claim_text(claim.id).compared) {
    if (!quantity.near_miss) continue;
    claim.controls.push_back({"near miss: " + quantity.what,
                              [quantity](void* values, const Number& step, const void*) {
                                miss(*static_cast<Values*>(values), quantity, step);
                              },
                              {}});
  }
}

}  // namespace steadyslide::proofs_checks
