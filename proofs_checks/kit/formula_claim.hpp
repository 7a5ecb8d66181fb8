#pragma once
// The form of claims that put a formula into equations: the check is handed a formula and knows no other, the formula
// knows no check, and a control is the formula with something in it changed.
//
//   Claim eq_04_flat_punch() {
//     return formula_claim<ContactProblem, PowerForm>("eq-04-flat-punch")
//         .cases(punches)
//         .quantity("load")                          // findings.compare("load", ...), described in the claim's text
//         .says([](const ContactProblem& p) { return PowerForm(...); })
//         .checked([]<Real R>(Findings& findings, const PowerForm& form, const ContactProblem& p) { ... })
//         .wrong("1/pi missing", [](PowerForm& form) { form.scale(pi); })
//         .near_miss("the amplitude", [](PowerForm& form, const Number& step) { ... });
//   }

#include <stdexcept>

#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks {

template <class Case, class Form>
class FormulaClaim : public ClaimBuilder<FormulaClaim<Case, Form>, Case, Form> {
 public:
  using ClaimBuilder<FormulaClaim, Case, Form>::ClaimBuilder;

  /// The formula; Form() if nothing is said.
  FormulaClaim&& says(std::function<Form(const Case&)> formula) && {
    formula_ = std::move(formula);
    return this->derived();
  }
  /// check.operator()<R>(Findings&, const Form&, const Case&), or with a const Context& behind these; without a type
  /// parameter where everything is exact.
  template <class Check>
  FormulaClaim&& checked(Check check) && {
    check_ = [check = std::move(check)](Findings& findings, const Form& form, const Case& c, const Context& context) {
      called_at(context, check, findings, form, c);
    };
    return this->derived();
  }
  /// change(Form&, const Number& step), or with a const Case& behind these, moves one value by `step`; a member is
  /// moved by this part of itself.
  template <class Change>
  FormulaClaim&& near_miss(const std::string& name, Change change) && {
    return this->control("near miss: " + name + " moved by ten times the tolerance",
                         [change = std::move(change)](Form& form, const Number& step, const Case& c) {
                           if constexpr (std::is_member_object_pointer_v<Change>) {
                             form.*change *= 1 + step;
                           } else if constexpr (std::is_invocable_v<const Change&, Form&, const Number&>) {
                             change(form, step);
                           } else {
                             change(form, step, c);
                           }
                         });
  }

  operator Claim() && {
    this->claim_.examine = [formula = std::move(formula_), check = std::move(check_)](
                               Findings& findings, const CaseData& data, const Context& context,
                               const ExaminedClaim::Change& change, const Number& step) {
      const Case& c = FormulaClaim::case_of(data.get());
      Form form = formula(c);
      if (change) change(&form, step, data.get());
      check(findings, form, c, context);
    };
    return claim_of(std::move(this->claim_));
  }

 private:
  std::function<Form(const Case&)> formula_ = [](const Case&) {
    if constexpr (std::is_default_constructible_v<Form>) return Form();
    throw std::logic_error("a claim that says nothing");
  };
  std::function<void(Findings&, const Form&, const Case&, const Context&)> check_;
};

template <class Case, class Form>
FormulaClaim<Case, Form> formula_claim(std::string id) {
  return FormulaClaim<Case, Form>(std::move(id));
}

}  // namespace steadyslide::proofs_checks
