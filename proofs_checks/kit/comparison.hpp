#pragma once
// The form in which most claims are said: what is measured knows no formula, what is predicted knows no measurement,
// and a control changes the prediction alone.
//
//   Claim rem_01_neglect() {
//     return compared<Parabola>("rem-01-neglect")
//         .cases(parabolas)    // CaseList<Parabola>(const Context&); a case has a name, or text_of()
//         .measured([]<Real R>(const Parabola& c) { return Values{{"peak", ...}}; })  // what it is says the text
//         .predicted([](const Parabola& c) { return Values{{"peak", ...}}; })
//         .wrong("the contact shifted to the front", scaled({"centre"}, -1))
//         .near_misses();
//   }
//
// Measurements are made once for a claim and all its controls. A case in which either side lacks a quantity counts as
// one without effect: too many of them, and nothing is shown.

#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks {

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
using ComparedClaim = ClaimBuilder<Case, Values>;

template <class Case>
ComparedClaim<Case> compared(std::string id) {
  return ComparedClaim<Case>(std::move(id));
}

}  // namespace steadyslide::proofs_checks
