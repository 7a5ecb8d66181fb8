#pragma once
// The form of claims that put a formula into equations: the check is handed a formula and knows no other, the formula
// knows no check, and a control is the formula with something in it changed.
//
//   Claim eq_04_flat_punch() {
//     return formula_claim<ContactProblem, PowerForm>("eq-04-flat-punch")
//         .cases(punches)
//         .says([](const ContactProblem& p) { return PowerForm(...); })
//         .checked([]<Real R>(Findings& findings, const PowerForm& form, const ContactProblem& p) {
//           findings.compare("load", ...);  // described in the claim's text
//         })
//         .wrong("1/pi missing", [](PowerForm& form) { form.scale(pi); })
//         .near_miss("the amplitude", [](PowerForm& form, const Number& step) { ... });
//   }

#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks {

template <class Case, class Form>
using FormulaClaim = ClaimBuilder<Case, Form>;

template <class Case, class Form>
FormulaClaim<Case, Form> formula_claim(std::string id) {
  return FormulaClaim<Case, Form>(std::move(id));
}

}  // namespace steadyslide::proofs_checks
