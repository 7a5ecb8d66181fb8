#pragma once
// The form in which most claims are said: what is measured knows no formula, what is predicted knows no measurement,
// and a control changes the prediction alone.
//
//   Claim rem_01_neglect() {
//     return compared<Parabola>("rem-01-neglect")
//         .cases(parabolas)    // CaseList<Parabola>(const Context&); a case has a name, or text_of()
//         .quantity("peak")    // the claim's text says what it is
//         .measured([]<Real R>(const Parabola& c) { return Values{{"peak", ...}}; })
//         .predicted([](const Parabola& c) { return Values{{"peak", ...}}; })
//         .wrong("the contact shifted to the front", scaled({"centre"}, -1))
//         .near_misses();
//   }
//
// Measurements are made once for a claim and all its controls. A case in which either side lacks a quantity counts as
// one without effect: too many of them, and nothing is shown.

#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks {

/// All that either has; throws std::logic_error where that is no quantity of the claim.
void compare(Findings& findings, const Values& measured, const Values& predicted);

/// One control for each quantity: what is predicted of it, moved by ten times the tolerance (a decided value: by 1e-94;
/// an order: by twice what it may differ).
void add_near_misses(ExaminedClaim& claim);

/// Changes of a prediction for ClaimBuilder::wrong(). The numbers of these names, those that are there, times a factor: a
/// number, or factor(case).
template <class Factor>
auto scaled(std::vector<std::string> names, Factor factor) {
  return [names = std::move(names), factor = std::move(factor)](Values& p, const auto& c) {
    if constexpr (std::is_invocable_v<const Factor&, decltype(c)>) {
      p.scale(names, Number(factor(c)));
    } else {
      p.scale(names, Number(factor));
    }
  };
}
/// Other values in place of those of these names.
inline auto replaced(Values values) {
  return [values = std::move(values)](Values& p) { p.set(values); };
}

template <class Case>
class ComparedClaim : public ClaimBuilder<ComparedClaim<Case>, Case, Values> {
 public:
  using ClaimBuilder<ComparedClaim, Case, Values>::ClaimBuilder;

  template <class F>
  ComparedClaim&& measured(F f) && {
    measured_ = route(std::move(f));
    return this->derived();
  }
  template <class F>
  ComparedClaim&& predicted(F f) && {
    predicted_ = route(std::move(f));
    return this->derived();
  }
  ComparedClaim&& near_misses() && {
    near_misses_ = true;
    return this->derived();
  }

  operator Claim() && {
    if (near_misses_) add_near_misses(this->claim_);
    this->claim_.examine = [measured = std::move(measured_), predicted = std::move(predicted_),
                            kept = std::make_shared<KeptForCases>()](
                               Findings& findings, const CaseData& data, const Context& context,
                               const ExaminedClaim::Change& change, const Number& step) {
      const Case& c = ComparedClaim::case_of(data.get());
      Values values = predicted(c, context);
      if (change) change(&values, step, data.get());
      compare(findings, kept->at(c, [&] { return measured(c, context); }), values);
    };
    return claim_of(std::move(this->claim_));
  }

 private:
  using Route = std::function<Values(const Case&, const Context&)>;

  template <class F>
  static Route route(F f) {
    return [f = std::move(f)](const Case& c, const Context& context) -> Values { return called_at(context, f, c); };
  }

  Route measured_;
  Route predicted_;
  bool near_misses_ = false;
};

template <class Case>
ComparedClaim<Case> compared(std::string id) {
  return ComparedClaim<Case>(std::move(id));
}

}  // namespace steadyslide::proofs_checks
