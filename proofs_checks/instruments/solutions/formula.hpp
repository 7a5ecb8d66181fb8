#pragma once
// A formula whose values live at the number type of the check: from an exact case to what it says at each precision.

#include <functional>
#include <tuple>

#include "numeric/number/real.hpp"

namespace steadyslide::proofs_checks {

template <template <class> class Form, class Case>
class Formula {
 public:
  /// build.template operator()<R>(c) is a Form<R>.
  template <class Build>
  static Formula from(Build build) {
    Formula formula;
    const auto put = [&]<numeric::Real R>() {
      std::get<At<R>>(formula.at_) = [build](const Case& c) { return build.template operator()<R>(c); };
    };
    put.template operator()<double>();
    put.template operator()<numeric::Real50>();
    put.template operator()<numeric::Real100>();
    return formula;
  }

  template <numeric::Real R>
  Form<R> at(const Case& c) const {
    return std::get<At<R>>(at_)(c);
  }

  /// The same with change(form, c) applied to what it says; `change` is generic in the form.
  template <class Change>
  Formula changed(Change change) const {
    return from([right = *this, change]<numeric::Real R>(const Case& c) {
      Form<R> form = right.template at<R>(c);
      change(form, c);
      return form;
    });
  }

 private:
  template <numeric::Real R>
  using At = std::function<Form<R>(const Case&)>;
  std::tuple<At<double>, At<numeric::Real50>, At<numeric::Real100>> at_;
};

}  // namespace steadyslide::proofs_checks
