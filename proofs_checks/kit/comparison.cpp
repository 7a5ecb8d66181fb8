#include "proofs_checks/kit/comparison.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// Moves what is predicted of one quantity as little as a check has to notice; numbers by `step`.
void miss(Values& predicted, const std::string& name, const HowCompared& how, const Number& step) {
  const Value* value = predicted.find(name);
  if (!value) return;
  if (const auto* number = std::get_if<Number>(value)) {
    predicted.set(name, how.absolute ? Number(*number + step) : Number(*number * (1 + step)));
  } else if (const auto* order = std::get_if<Order>(value)) {
    predicted.set(name, Order{order->rate + 2 * how.tolerance});
  } else if (const auto* exponent = std::get_if<Exponent>(value)) {
    predicted.set(name, *exponent + Exponent::angle(tiny()));
  } else if (const auto* rational = std::get_if<Rational>(value)) {
    predicted.set(name, Rational(*rational + tiny()));
  }
}

void compare(Findings& findings, const NamedQuantity& compared, const Value& measured, const Value& predicted) {
  const auto& [name, quantity] = compared;
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

}  // namespace

void compare(Findings& findings, const Values& measured, const Values& predicted) {
  for (const Values* values : {&measured, &predicted}) {
    for (const Values::Named& named : *values) findings.quantity(named.name);
  }
  for (const NamedQuantity& quantity : findings.quantities()) {
    const Value* a = measured.find(quantity.name);
    const Value* b = predicted.find(quantity.name);
    if (a && b) {
      compare(findings, quantity, *a, *b);
    } else if (a || b) {  // neither: the case is not one of this quantity
      findings.skip(quantity.quantity);
    }
  }
}

void add_near_misses(ExaminedClaim& claim) {
  for (const QuantityText& text : claim_text(claim.id).compared) {
    if (!text.how.near_miss) continue;
    claim.controls.push_back({"near miss: " + text.what,
                              [name = text.name, how = text.how](void* values, const Number& step, const void*) {
                                miss(*static_cast<Values*>(values), name, how,
                                     how.tolerance != 0 ? Number(10 * how.tolerance) : step);
                              },
                              {}});
  }
}

}  // namespace steadyslide::proofs_checks
