#pragma once
// The form of claims that put a formula into equations: the check is handed a formula and knows no other, the formula
// knows no check, and a control is the formula with something in it changed.
//
//   Claim eq_04_flat_punch() {
//     return formula_claim<ContactProblem, PowerForm>("eq-04-flat-punch")
//         .cases(punches)
//         .says([](const ContactProblem& p) { return PowerForm(...); })
//         .checked([]<Real R>(Findings& findings, const PowerForm& form, const ContactProblem& p) { ... })
//         .wrong("1/pi missing", [](PowerForm& form, const ContactProblem&) { form.scale(pi); })
//         .near_miss("the amplitude", [](PowerForm& form, const Number& step, const ContactProblem&) { ... });
//   }

#include "proofs_checks/kit/cases.hpp"
#include "proofs_checks/kit/findings.hpp"
#include "proofs_checks/kit/values.hpp"

namespace steadyslide::proofs_checks {

/// The runner's view: begins each case, hands data and change to the check.
struct FormulaCheck {
  /// Changes a formula; `step`: what a near miss moves, ten times the tolerance.
  using Change = std::function<void(void* form, const Number& step, const void* data)>;
  using Examine = std::function<void(Findings&, const void* data, const Context&, const Change&, const Number& step)>;

  std::string id;
  Precision precision = Precision::as_asked;
  CaseSource cases;
  Examine examine;
  std::vector<std::pair<std::string, Change>> wrong;
};
Claim claim_of(FormulaCheck check);

template <class Case, class Form>
class FormulaClaim {
 public:
  explicit FormulaClaim(std::string id) { check_.id = std::move(id); }

  /// list(const Context&) is a CaseList<Case>; text_of(c) names a case.
  template <class List>
  FormulaClaim cases(List list) && {
    list_ = std::move(list);
    return std::move(*this);
  }
  /// At the others the statement says nothing special (a jump of height zero).
  FormulaClaim effective_where(std::function<bool(const Case&)> effective) && {
    effective_ = std::move(effective);
    return std::move(*this);
  }
  FormulaClaim precision(Precision precision) && {
    check_.precision = precision;
    return std::move(*this);
  }
  FormulaClaim says(std::function<Form(const Case&)> formula) && {
    formula_ = std::move(formula);
    return std::move(*this);
  }
  /// check.operator()<R>(Findings&, const Form&, const Case&), or with a const Context& behind these; without a type
  /// parameter where everything is exact.
  template <class Check>
  FormulaClaim checked(Check check) && {
    run_ = [check = std::move(check)](Findings& findings, const Form& form, const Case& c, const Context& context) {
      if constexpr (std::is_invocable_v<Check, Findings&, const Form&, const Case&>) {
        check(findings, form, c);
      } else {
        numeric::at_precision(context.digits, [&]<numeric::Real R>() {
          if constexpr (requires { check.template operator()<R>(findings, form, c); }) {
            check.template operator()<R>(findings, form, c);
          } else {
            check.template operator()<R>(findings, form, c, context);
          }
        });
      }
    };
    return std::move(*this);
  }
  template <class Change>
  FormulaClaim wrong(std::string name, Change change) && {
    check_.wrong.emplace_back(std::move(name), [change = std::move(change)](void* form, const Number&, const void* c) {
      change(*static_cast<Form*>(form), *static_cast<const Case*>(c));
    });
    return std::move(*this);
  }
  /// change(Form&, const Number& step, const Case&) moves one value by `step`.
  template <class Change>
  FormulaClaim near_miss(const std::string& name, Change change) && {
    check_.wrong.emplace_back("near miss: " + name + " moved by ten times the tolerance",
                              [change = std::move(change)](void* form, const Number& step, const void* c) {
                                change(*static_cast<Form*>(form), step, *static_cast<const Case*>(c));
                              });
    return std::move(*this);
  }

  operator Claim() && {
    check_.cases = case_source<Case>(std::move(list_), std::move(effective_));
    check_.examine = [formula = std::move(formula_), run = std::move(run_)](
                         Findings& findings, const void* data, const Context& context,
                         const FormulaCheck::Change& change, const Number& step) {
      const Case& c = *static_cast<const Case*>(data);
      Form form = formula(c);
      if (change) change(&form, step, data);
      run(findings, form, c, context);
    };
    return claim_of(std::move(check_));
  }

 private:
  FormulaCheck check_;
  std::function<CaseList<Case>(const Context&)> list_;
  std::function<bool(const Case&)> effective_;
  std::function<Form(const Case&)> formula_;
  std::function<void(Findings&, const Form&, const Case&, const Context&)> run_;
};

template <class Case, class Form>
FormulaClaim<Case, Form> formula_claim(std::string id) {
  return FormulaClaim<Case, Form>(std::move(id));
}

}  // namespace steadyslide::proofs_checks
