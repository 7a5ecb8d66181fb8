#pragma once
// Builds claims from cases, a formula, a check, and controls. A control is the formula with one change in it, or cases
// that the hypotheses exclude. The claim's text lists the compared quantities.
//
// Most claims compare measured and predicted values. The measurement uses no formula, the prediction uses no
// measurement, and a control changes the prediction alone.
//
//   Claim rem_01_neglect() {
//     return compared<Parabola>("rem-01-neglect")
//         .cases(parabolas)    // CaseList<Parabola>(const Context&); a case has a name, or text_of()
//         .measured([]<Real R>(const Parabola& c) { return Values{{"peak", ...}}; })
//         .predicted([](const Parabola& c) { return Values{{"peak", ...}}; })
//         .wrong("the contact shifted to the front", scaled({"centre"}, -1))
//         .near_misses();
//   }
//
// Measurements are made once for a claim and all its controls. A case in which one side lacks a quantity counts as a
// case without effect. Too many such cases leave the claim undecided.
//
// Other claims put a formula into equations. The check receives the formula as an argument and uses no other; the
// formula does not depend on the check.
//
//   Claim eq_04_flat_punch() {
//     return formula_claim<ContactProblem, PowerForm>("eq-04-flat-punch")
//         .cases(punches)
//         .says([](const ContactProblem& p) { return PowerForm(...); })
//         .checked([]<Real R>(Findings& findings, const PowerForm& form, const ContactProblem& p) {
//           findings.compare("load", ...);
//         })
//         .wrong("1/pi missing", [](PowerForm& form) { form.scale(pi); })
//         .near_miss("the amplitude", [](PowerForm& form, const Number& step) { ... });
//   }

#include <functional>
#include <stdexcept>

#include "proofs_checks/kit/cases.hpp"
#include "proofs_checks/kit/findings.hpp"
#include "proofs_checks/kit/values.hpp"

namespace steadyslide::proofs_checks {

/// A claim as the runner sees it: cases and formula without their types, functions without their precision.
struct ExaminedClaim {
  /// Changes a formula. `step` is the size of a near miss, ten times the tolerance.
  using Change = std::function<void(void* formula, const Number& step, const void* data)>;
  using Examine = std::function<void(Findings&, const void* data, const Context&, const Change&, const Number& step)>;
  struct Variant {
    std::string name;
    Change change;
    CaseSource cases;  ///< if empty, the cases of the claim
  };

  std::string id;
  Precision precision = Precision::as_asked;
  CaseSource cases;
  std::function<bool(const void*)> effective;
  Examine examine;
  std::vector<Variant> controls;
};

Claim claim_of(ExaminedClaim claim);

/// Compares all quantities that both sides have, and skips those that one side lacks. Throws std::logic_error if a
/// value has the name of no quantity of the claim.
void compare(Findings& findings, const Values& measured, const Values& predicted);

/// Adds one control for each quantity of the text that has near misses. The control changes the predicted value by ten
/// times the tolerance, a decided value by 1e-94, an order by twice its tolerance.
void add_near_misses(ExaminedClaim& claim);

/// Returns f(arguments...). A type parameter of f becomes the number type of the context's digits. If f takes a context
/// after the arguments, it receives this one.
template <class F, class... Arguments>
decltype(auto) called_at(const Context& context, const F& f, Arguments&... arguments) {
  if constexpr (std::is_invocable_v<const F&, Arguments&...>) {
    return f(arguments...);
  } else if constexpr (std::is_invocable_v<const F&, Arguments&..., const Context&>) {
    return f(arguments..., context);
  } else if constexpr (requires { f.template operator()<double>(arguments...); }) {
    return numeric::at_precision(context.digits,
                                 [&]<numeric::Real R>() { return f.template operator()<R>(arguments...); });
  } else {
    return numeric::at_precision(context.digits,
                                 [&]<numeric::Real R>() { return f.template operator()<R>(arguments..., context); });
  }
}

/// A claim built step by step from cases and a formula of these types. It converts to Claim.
template <class Case, class Form>
class ClaimBuilder {
 public:
  explicit ClaimBuilder(std::string id) { claim_.id = std::move(id); }

  /// Sets the cases: list(const Context&) returns a CaseList<Case>. The name of a case c is text_of(c) if this function
  /// exists, otherwise c.name.
  template <class List>
  ClaimBuilder&& cases(List list) && {
    claim_.cases = case_source<Case>(std::move(list));
    return std::move(*this);
  }
  /// Sets the condition for effective cases. At the other cases the statement says nothing special (a friction jump of
  /// height zero).
  ClaimBuilder&& effective_where(std::function<bool(const Case&)> effective) && {
    claim_.effective = [effective = std::move(effective)](const void* data) { return effective(case_of(data)); };
    return std::move(*this);
  }
  ClaimBuilder&& precision(Precision precision) && {
    claim_.precision = precision;
    return std::move(*this);
  }
  /// Sets the formula, formula(const Case&), called by called_at(). The default is Form(). In a comparison of values,
  /// the formula is the prediction.
  template <class Formula>
  ClaimBuilder&& says(Formula formula) && {
    formula_ = [formula = std::move(formula)](const Case& c, const Context& context) -> Form {
      return called_at(context, formula, c);
    };
    return std::move(*this);
  }
  template <class Formula>
  ClaimBuilder&& predicted(Formula formula) && {
    return std::move(*this).says(std::move(formula));
  }
  /// Sets the check, check(Findings&, const Form&, const Case&), called by called_at().
  template <class Check>
  ClaimBuilder&& checked(Check check) && {
    check_ = [check = std::move(check)](Findings& findings, const Form& form, const Case& c, const Context& context) {
      called_at(context, check, findings, form, c);
    };
    return std::move(*this);
  }
  /// Sets the measurement, measure(const Case&), called by called_at(). It returns the values that the predicted ones
  /// are compared with, and runs once for the claim and all its controls.
  template <class Measure>
  ClaimBuilder&& measured(Measure measure) && {
    check_ = [measure = std::move(measure), kept = std::make_shared<KeptForCases>()](
                 Findings& findings, const Form& predicted, const Case& c, const Context& context) {
      compare(findings, kept->at(c, [&]() -> Values { return called_at(context, measure, c); }), predicted);
    };
    return std::move(*this);
  }

  /// Adds a control: change(Form&) or change(Form&, const Case&) makes the formula wrong.
  template <class Change>
  ClaimBuilder&& wrong(std::string name, Change change) && {
    return control(std::move(name), [change = std::move(change)](Form& form, const Number&, const Case& c) {
      if constexpr (std::is_invocable_v<const Change&, Form&>) {
        change(form);
      } else {
        change(form, c);
      }
    });
  }
  /// Adds a control: the formula with another value of a member.
  template <class Member, class Value>
  ClaimBuilder&& wrong(std::string name, Member member, Value value) && {
    return std::move(*this).wrong(std::move(name),
                                  [member, value = std::move(value)](Form& form) { form.*member = value; });
  }
  /// Adds a control: the statement at cases that its hypotheses exclude, where it is wrong.
  template <class List>
  ClaimBuilder&& wrong_beyond(std::string name, List list) && {
    claim_.controls.push_back({std::move(name), {}, case_source<Case>(std::move(list))});
    return std::move(*this);
  }
  /// Adds a near miss: change(Form&, const Number& step), or the same with a const Case& as third argument, changes one
  /// value by `step`. A pointer to a member multiplies the member by 1 + step.
  template <class Change>
  ClaimBuilder&& near_miss(const std::string& name, Change change) && {
    return control("near miss: " + name + " moved by ten times the tolerance",
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
  /// Adds the near misses of add_near_misses() to a comparison of values.
  ClaimBuilder&& near_misses() && {
    add_near_misses(claim_);
    return std::move(*this);
  }

  operator Claim() && {
    claim_.examine = [formula = std::move(formula_), check = std::move(check_)](
                         Findings& findings, const void* data, const Context& context,
                         const ExaminedClaim::Change& change, const Number& step) {
      const Case& c = case_of(data);
      Form form = formula(c, context);
      if (change) change(&form, step, data);
      check(findings, form, c, context);
    };
    return claim_of(std::move(claim_));
  }

 private:
  static const Case& case_of(const void* data) { return *static_cast<const Case*>(data); }

  /// Adds a control that calls change(Form&, const Number& step, const Case&).
  template <class Change>
  ClaimBuilder&& control(std::string name, Change change) {
    claim_.controls.push_back({std::move(name),
                               [change = std::move(change)](void* form, const Number& step, const void* data) {
                                 change(*static_cast<Form*>(form), step, case_of(data));
                               },
                               {}});
    return std::move(*this);
  }

  ExaminedClaim claim_;
  std::function<Form(const Case&, const Context&)> formula_ = [](const Case&, const Context&) {
    if constexpr (std::is_default_constructible_v<Form>) return Form();
    throw std::logic_error("a claim that says nothing");
  };
  std::function<void(Findings&, const Form&, const Case&, const Context&)> check_;
};

template <class Case>
using ComparedClaim = ClaimBuilder<Case, Values>;
template <class Case>
ComparedClaim<Case> compared(std::string id) {
  return ComparedClaim<Case>(std::move(id));
}

template <class Case, class Form>
using FormulaClaim = ClaimBuilder<Case, Form>;
template <class Case, class Form>
FormulaClaim<Case, Form> formula_claim(std::string id) {
  return FormulaClaim<Case, Form>(std::move(id));
}

/// Returns a measurement or prediction of one quantity: f(case) in the number type of the context's digits.
template <class F>
auto one_value(std::string name, F f) {
  return [name = std::move(name), f = std::move(f)]<numeric::Real R>(const auto& c) {
    return Values{{name, f.template operator()<R>(c)}};
  };
}

/// Returns a change of a prediction, for ClaimBuilder::wrong(). It multiplies the numbers with these names, if present,
/// by a factor: a number, or factor(case).
template <class Factor>
auto scaled(std::vector<std::string> names, Factor factor) {
  if constexpr (std::is_constructible_v<Number, Factor>) {
    return [names = std::move(names), factor = Number(factor)](Values& p, const auto&) { p.scale(names, factor); };
  } else {
    return [names = std::move(names), factor = std::move(factor)](Values& p, const auto& c) {
      p.scale(names, Number(factor(c)));
    };
  }
}
/// Returns a change of a prediction that replaces the values with the same names, if present.
inline auto replaced(Values values) {
  return [values = std::move(values)](Values& p) { p.set(values); };
}

}  // namespace steadyslide::proofs_checks
