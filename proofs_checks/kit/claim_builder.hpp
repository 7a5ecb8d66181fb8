#pragma once
// What both forms of a claim have in common (comparison.hpp, formula_claim.hpp): cases, the quantities that are
// compared at them, and controls. A control is the formula with something in it changed, or cases that the hypotheses
// exclude.

#include <functional>

#include "proofs_checks/kit/cases.hpp"
#include "proofs_checks/kit/findings.hpp"
#include "proofs_checks/kit/values.hpp"

namespace steadyslide::proofs_checks {

/// How a quantity is compared. What it is stands in the claim's text, under "Compared".
struct HowCompared {
  /// Of numbers: that of the precision if 0. Of orders: the largest difference of rates. Of fits: of error bars.
  double tolerance = 0;
  bool absolute = false;  ///< the difference itself, not relative to the larger value: where zero is predicted
  bool at_most = false;   ///< the prediction is a bound of what is measured
  double required = 0.5;  ///< the part of the cases that has to be effective
  bool near_miss = true;  ///< false for truth values and for bounds that are not attained
};

/// The runner's view of a claim: cases and formula without their types, functions without their precision.
struct ExaminedClaim {
  /// Changes a formula; `step`: what a near miss moves, ten times the tolerance.
  using Change = std::function<void(void* formula, const Number& step, const void* data)>;
  using Examine = std::function<void(Findings&, const CaseData&, const Context&, const Change&, const Number& step)>;
  struct Variant {
    std::string name;
    Change change;
    CaseSource cases;  ///< empty: the claim's
  };

  std::string id;
  Precision precision = Precision::as_asked;
  CaseSource cases;
  std::function<bool(const void*)> effective;
  std::vector<std::pair<std::string, HowCompared>> quantities;
  Examine examine;
  std::vector<Variant> controls;
};

/// With their descriptions from the claim's text; a tolerance that is not given is this one. Throws std::logic_error
/// where the claim compares a quantity that its text does not describe, or the other way round.
std::vector<NamedQuantity> quantities_of(const ExaminedClaim& claim, double tolerance);

Claim claim_of(ExaminedClaim claim);

/// f(arguments...), at the number type of the context's digits where f has a type parameter, with the context behind
/// the arguments where f takes one.
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

template <class Derived, class Case, class Form>
class ClaimBuilder {
 public:
  explicit ClaimBuilder(std::string id) { claim_.id = std::move(id); }

  /// list(const Context&) is a CaseList<Case>; a case is named by text_of(c), or else by its member `name`.
  template <class List>
  Derived&& cases(List list) && {
    claim_.cases = case_source<Case>(std::move(list));
    return derived();
  }
  /// At the others the statement says nothing special (a jump of height zero).
  Derived&& effective_where(std::function<bool(const Case&)> effective) && {
    claim_.effective = [effective = std::move(effective)](const void* data) { return effective(case_of(data)); };
    return derived();
  }
  Derived&& precision(Precision precision) && {
    claim_.precision = precision;
    return derived();
  }
  Derived&& quantity(std::string name, HowCompared how = {}) && {
    claim_.quantities.emplace_back(std::move(name), how);
    return derived();
  }
  Derived&& quantities(std::initializer_list<const char*> names, HowCompared how = {}) && {
    for (const char* name : names) claim_.quantities.emplace_back(name, how);
    return derived();
  }
  /// change(Form&) or change(Form&, const Case&) makes a wrong formula.
  template <class Change>
  Derived&& wrong(std::string name, Change change) && {
    return control(std::move(name), [change = std::move(change)](Form& form, const Number&, const Case& c) {
      if constexpr (std::is_invocable_v<const Change&, Form&>) {
        change(form);
      } else {
        change(form, c);
      }
    });
  }
  /// The statement is wrong at these cases, which its hypotheses exclude.
  template <class List>
  Derived&& wrong_beyond(std::string name, List list) && {
    claim_.controls.push_back({std::move(name), {}, case_source<Case>(std::move(list))});
    return derived();
  }

 protected:
  static const Case& case_of(const void* data) { return *static_cast<const Case*>(data); }
  Derived&& derived() { return static_cast<Derived&&>(*this); }

  /// change(Form&, const Number& step, const Case&).
  template <class Change>
  Derived&& control(std::string name, Change change) {
    claim_.controls.push_back({std::move(name),
                               [change = std::move(change)](void* form, const Number& step, const void* data) {
                                 change(*static_cast<Form*>(form), step, case_of(data));
                               },
                               {}});
    return derived();
  }

  ExaminedClaim claim_;
};

}  // namespace steadyslide::proofs_checks
