#pragma once
// The form in which most claims are said: what is measured knows no formula, what is predicted knows no measurement,
// and a control changes the prediction alone.
//
//   Claim rem_01_neglect() {
//     return compared<Parabola>("rem-01-neglect")
//         .cases(parabolas)                          // CaseList<Parabola>(const Context&); text_of(Parabola) names one
//         .quantity({"peak", "largest pressure over the frictionless one", {"solved problems", "cos(pi alpha) ..."}})
//         .measured([]<Real R>(const Parabola& c) { return Values{{"peak", ...}}; })
//         .predicted([](const Parabola& c) { return Values{{"peak", ...}}; })
//         .wrong("the contact shifted to the front", [](Values& p, const Parabola&) { p["centre"] *= -1; })
//         .near_misses();
//   }
//
// Measurements are made once for a claim and all its controls. A case in which either side lacks a quantity counts as
// one without effect: too many of them, and nothing is shown.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <tuple>

#include "proofs_checks/kit/cases.hpp"
#include "proofs_checks/kit/findings.hpp"
#include "proofs_checks/kit/values.hpp"

namespace steadyslide::proofs_checks {

/// What is compared, and how.
struct Compared {
  std::string name;                 ///< in Values
  std::string what;                 ///< for the reader
  std::vector<std::string> routes;  ///< that of the measurement, that of the prediction
  /// Of numbers: that of the precision if 0. Of orders: the largest difference of rates.
  double tolerance = 0;
  bool absolute = false;  ///< the difference itself, not relative to the larger value: where zero is predicted
  bool at_most = false;   ///< the prediction is a bound of what is measured
  double required = 0.5;  ///< the part of the cases that has to be effective
  bool near_miss = true;  ///< false for truth values and for bounds that are not attained
};

/// The runner's view of such a claim: cases without their type, functions without their precision.
struct Comparison {
  using Measure = std::function<Values(const void*, const Context&)>;
  using Change = std::function<void(Values&, const void*)>;

  std::string id;
  Precision precision = Precision::as_asked;
  CaseSource cases;
  std::vector<Compared> quantities;
  Measure measured;
  Measure predicted;
  std::vector<std::pair<std::string, Change>> wrong;
  std::vector<std::pair<std::string, CaseSource>> elsewhere;  ///< cases outside of the hypotheses
  bool near_misses = false;
};
Claim claim_of(Comparison comparison);

namespace detail {

/// f at the number type of the context's digits, or in double where f has no type parameter; with the context where f
/// takes one.
template <class Case, class F>
Comparison::Measure measure_of(F f) {
  return [f = std::move(f)](const void* data, const Context& context) -> Values {
    const Case& c = *static_cast<const Case*>(data);
    if constexpr (std::is_invocable_v<F, const Case&>) {
      return f(c);
    } else if constexpr (std::is_invocable_v<F, const Case&, const Context&>) {
      return f(c, context);
    } else {
      return numeric::at_precision(context.digits, [&]<numeric::Real R>() -> Values {
        if constexpr (requires { f.template operator()<R>(c); }) {
          return f.template operator()<R>(c);
        } else {
          return f.template operator()<R>(c, context);
        }
      });
    }
  };
}

}  // namespace detail

template <class Case>
class ComparedClaim {
 public:
  explicit ComparedClaim(std::string id) { comparison_.id = std::move(id); }

  /// list(const Context&) is a CaseList<Case>; text_of(c) names a case.
  template <class List>
  ComparedClaim cases(List list) && {
    list_ = std::move(list);
    return std::move(*this);
  }
  /// At the others the statement says nothing special (a jump of height zero).
  ComparedClaim effective_where(std::function<bool(const Case&)> effective) && {
    effective_ = std::move(effective);
    return std::move(*this);
  }
  ComparedClaim precision(Precision precision) && {
    comparison_.precision = precision;
    return std::move(*this);
  }
  ComparedClaim quantity(Compared quantity) && {
    comparison_.quantities.push_back(std::move(quantity));
    return std::move(*this);
  }
  template <class F>
  ComparedClaim measured(F f) && {
    comparison_.measured = detail::measure_of<Case>(std::move(f));
    return std::move(*this);
  }
  template <class F>
  ComparedClaim predicted(F f) && {
    comparison_.predicted = detail::measure_of<Case>(std::move(f));
    return std::move(*this);
  }
  /// change(Values&, const Case&) makes a wrong formula of the prediction.
  template <class Change>
  ComparedClaim wrong(std::string name, Change change) && {
    comparison_.wrong.emplace_back(std::move(name), [change = std::move(change)](Values& values, const void* data) {
      change(values, *static_cast<const Case*>(data));
    });
    return std::move(*this);
  }
  /// The statement is wrong at these cases, which its hypotheses exclude.
  template <class List>
  ComparedClaim wrong_beyond(std::string name, List list) && {
    elsewhere_.emplace_back(std::move(name), std::move(list));
    return std::move(*this);
  }
  /// One control for each quantity: what is predicted of it, moved by ten times the tolerance (a decided value: by
  /// 1e-94; an order: by twice what it may differ).
  ComparedClaim near_misses() && {
    comparison_.near_misses = true;
    return std::move(*this);
  }

  operator Claim() && {
    comparison_.cases = case_source<Case>(list_, effective_);
    for (auto& [name, list] : elsewhere_) {
      comparison_.elsewhere.emplace_back(name, case_source<Case>(list, effective_));
    }
    return claim_of(std::move(comparison_));
  }

 private:
  using List = std::function<CaseList<Case>(const Context&)>;

  Comparison comparison_;
  List list_;
  std::function<bool(const Case&)> effective_;
  std::vector<std::pair<std::string, List>> elsewhere_;
};

template <class Case>
ComparedClaim<Case> compared(std::string id) {
  return ComparedClaim<Case>(std::move(id));
}

}  // namespace steadyslide::proofs_checks
