#include "proofs_checks/kit/comparison.hpp"

#include <algorithm>
#include <stdexcept>

namespace steadyslide::proofs_checks {
namespace {

/// Far below every tolerance of the ledger, and still visible to exact arithmetic.
Rational tiny() {
  static const Rational value = parse_rational("1e-94");
  return value;
}

double tolerance_of(const Compared& quantity, const Context& context) {
  if (quantity.tolerance != 0) return quantity.tolerance;
  return numeric::at_precision(context.digits, []<numeric::Real R>() { return tolerance<R>(); });
}

/// What is measured, once for a claim and all its controls.
class Measurements {
 public:
  explicit Measurements(const Comparison& comparison) : comparison_(comparison) {}

  const Examples& examples(const Context& context) { return slot(context).examples; }
  const Values& at(const Context& context, std::size_t k) {
    Slot& s = slot(context);
    if (!s.values[k]) s.values[k] = comparison_.measured(s.examples.cases[k].data.get(), context);
    return *s.values[k];
  }

 private:
  struct Slot {
    Examples examples;
    std::vector<std::optional<Values>> values;
  };
  Slot& slot(const Context& context) {
    const auto [found, is_new] = slots_.try_emplace({context.digits, context.seed, context.quick});
    if (is_new) {
      found->second.examples = comparison_.cases(context);
      found->second.values.resize(found->second.examples.cases.size());
    }
    return found->second;
  }

  const Comparison& comparison_;
  std::map<std::tuple<numeric::Digits, std::uint64_t, bool>, Slot> slots_;
};

class Runner {
 public:
  explicit Runner(Comparison comparison) : comparison_(std::move(comparison)), measurements_(comparison_) {}

  const Comparison& comparison() const { return comparison_; }

  std::vector<Evidence> examine(const Context& asked, const Comparison::Change& change) {
    const Context context = measuring(asked);
    const Examples& examples = measurements_.examples(context);
    return walk(context, examples, change, [&](std::size_t k) { return measurements_.at(context, k); });
  }

  std::vector<Evidence> examine_elsewhere(const Context& asked, const CaseSource& source) {
    const Context context = measuring(asked);
    const Examples examples = source(context);
    return walk(context, examples, {},
                [&](std::size_t k) { return comparison_.measured(examples.cases[k].data.get(), context); });
  }

  /// Moves what is predicted of one quantity as little as a check has to notice.
  void miss(Values& predicted, const Compared& quantity, const Context& asked) const {
    const Value* value = predicted.find(quantity.name);
    if (!value) return;
    const Number step = 10 * tolerance_of(quantity, measuring(asked));
    if (const auto* number = std::get_if<Number>(value)) {
      predicted.set(quantity.name, quantity.absolute ? Number(*number + step) : Number(*number * (1 + step)));
    } else if (const auto* order = std::get_if<Order>(value)) {
      predicted.set(quantity.name, Order{order->rate + 2 * quantity.tolerance});
    } else if (const auto* exponent = std::get_if<Exponent>(value)) {
      predicted.set(quantity.name, *exponent + Exponent::angle(tiny()));
    } else if (const auto* rational = std::get_if<Rational>(value)) {
      predicted.set(quantity.name, Rational(*rational + tiny()));
    }
  }

  Context measuring(const Context& asked) const {
    return {digits_at(comparison_.precision, asked), asked.seed, asked.quick};
  }

 private:
  template <class Measured>
  std::vector<Evidence> walk(const Context& context, const Examples& examples, const Comparison::Change& change,
                             const Measured& measured) const {
    return gather([&] {
      Findings findings;
      for (std::size_t k = 0; k < examples.cases.size(); ++k) {
        const ExaminedCase& c = examples.cases[k];
        findings.begin_case(c.where, c.effective);
        Values predicted = comparison_.predicted(c.data.get(), context);
        if (change) change(predicted, c.data.get());
        compare(findings, context, measured(k), predicted);
      }
      return findings.evidence(examples.detail);
    });
  }

  void compare(Findings& findings, const Context& context, const Values& measured, const Values& predicted) const {
    for (const Values* values : {&measured, &predicted}) {
      for (const Values::Named& named : *values) {
        const auto known = std::ranges::find(comparison_.quantities, named.name, &Compared::name);
        if (known == comparison_.quantities.end()) throw std::logic_error("not a quantity of the claim: " + named.name);
      }
    }
    for (const Compared& quantity : comparison_.quantities) {
      const Value* a = measured.find(quantity.name);
      const Value* b = predicted.find(quantity.name);
      if (a && b) {
        compare(findings, context, quantity, *a, *b);
      } else {
        // Neither side: the case is not one of this quantity.
        if (a || b) findings.skip(numbers(quantity, context));
      }
    }
  }

  static Quantity numbers(const Compared& quantity, const Context& context) {
    return {quantity.what, quantity.routes, tolerance_of(quantity, context), quantity.required};
  }

  static void compare(Findings& findings, const Context& context, const Compared& quantity, const Value& measured,
                      const Value& predicted) {
    if (const auto* order = std::get_if<Order>(&measured)) {
      findings.measure({quantity.what, order->rate, order->error_bar, std::get<Order>(predicted).rate,
                        quantity.tolerance, order->detail});
    } else if (const auto* number = std::get_if<Number>(&measured)) {
      const Number& expected = std::get<Number>(predicted);
      if (quantity.at_most && *number <= expected) return findings.compare(numbers(quantity, context), 0);
      const Number difference = abs(*number - expected);
      findings.compare(numbers(quantity, context), quantity.absolute ? static_cast<double>(difference)
                                                                     : relative_difference<Number>(*number, expected));
    } else {
      findings.decide(quantity.what, measured == predicted);
    }
  }

  Comparison comparison_;
  Measurements measurements_;
};

}  // namespace

Claim claim_of(Comparison comparison) {
  const auto runner = std::make_shared<Runner>(std::move(comparison));
  Claim claim{claim_text(runner->comparison().id), {}, {}};
  claim.examine = [runner](const Context& context) { return runner->examine(context, {}); };
  for (const auto& [name, change] : runner->comparison().wrong) {
    claim.controls.push_back(
        {name, [runner, &change = change](const Context& context) { return runner->examine(context, change); }});
  }
  for (const auto& [name, source] : runner->comparison().elsewhere) {
    claim.controls.push_back(
        {name, [runner, &source = source](const Context& c) { return runner->examine_elsewhere(c, source); }});
  }
  if (!runner->comparison().near_misses) return claim;
  for (const Compared& quantity : runner->comparison().quantities) {
    if (!quantity.near_miss) continue;
    const auto examine = [runner, &quantity](const Context& context) {
      return runner->examine(context, [&](Values& p, const void*) { runner->miss(p, quantity, context); });
    };
    claim.controls.push_back({"near miss: " + quantity.what, examine});
  }
  return claim;
}

}  // namespace steadyslide::proofs_checks
