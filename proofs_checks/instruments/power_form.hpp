#pragma once
// A traction t = amplitude_k prod_j |x - e_j|^{p_j}, written down from a formula of the paper, open to be changed: a
// control is the right form with something in it replaced. At every precision of the numeric layer.

#include <functional>
#include <tuple>
#include <vector>

#include "model/contact_problem.hpp"
#include "numeric/cauchy/power_traction.hpp"

namespace steadyslide::proofs_checks {

using numeric::Real;
using numeric::Real100;
using numeric::Real50;

// (Not constrained: g++ 12 takes no constrained templates as template arguments.)
template <class R>
struct PowerForm {
  R left_end;
  std::vector<R> lengths;
  std::vector<Exponent> exponents;  ///< exact
  std::vector<numeric::Power<R>> powers;
  std::vector<R> amplitudes;

  /// Replaces exponent j, exactly.
  void set_exponent(std::size_t j, const Exponent& exponent) {
    exponents[j] = exponent;
    powers[j] = numeric::Power<R>::of(exponent);
  }
  void move_power(std::size_t j, const R& step) {
    powers[j].value += step;
    powers[j].plus_one += step;
  }
  void scale(const R& factor) {
    for (R& amplitude : amplitudes) amplitude *= factor;
  }
  std::vector<R> points() const {
    std::vector<R> all{left_end};
    for (const R& length : lengths) all.push_back(all.back() + length);
    return all;
  }
  /// All powers above -1.
  bool is_integrable() const {
    for (const numeric::Power<R>& power : powers) {
      if (!(power.plus_one > 0)) return false;
    }
    return true;
  }
  numeric::PowerTraction<R> traction() const {
    return {numeric::FundamentalSolution<R>(left_end, lengths, powers), amplitudes};
  }
};

/// The form on exactly known points.
template <Real R>
PowerForm<R> power_form(const std::vector<Rational>& points, std::vector<Exponent> exponents,
                        std::vector<R> amplitudes) {
  PowerForm<R> form{numeric::to_real<R>(points.front()), {}, std::move(exponents), {}, std::move(amplitudes)};
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    form.lengths.push_back(numeric::to_real<R>(points[k + 1] - points[k]));
  }
  for (const Exponent& exponent : form.exponents) form.powers.push_back(numeric::Power<R>::of(exponent));
  return form;
}

/// A formula: from an exact case to what it says at each precision.
template <template <class> class Form, class Case>
class Formula {
 public:
  /// build.template operator()<R>(c) is a Form<R>.
  template <class Build>
  static Formula from(Build build) {
    Formula formula;
    std::get<At<double>>(formula.at_) = [build](const Case& c) { return build.template operator()<double>(c); };
    std::get<At<Real50>>(formula.at_) = [build](const Case& c) { return build.template operator()<Real50>(c); };
    std::get<At<Real100>>(formula.at_) = [build](const Case& c) { return build.template operator()<Real100>(c); };
    return formula;
  }

  template <Real R>
  Form<R> at(const Case& c) const {
    return std::get<At<R>>(at_)(c);
  }

  /// The same with change(form, c) applied to what it says; `change` is generic in the form.
  template <class Change>
  Formula changed(Change change) const {
    return from([right = *this, change]<Real R>(const Case& c) {
      Form<R> form = right.template at<R>(c);
      change(form, c);
      return form;
    });
  }

 private:
  template <Real R>
  using At = std::function<Form<R>(const Case&)>;
  std::tuple<At<double>, At<Real50>, At<Real100>> at_;
};

}  // namespace steadyslide::proofs_checks
