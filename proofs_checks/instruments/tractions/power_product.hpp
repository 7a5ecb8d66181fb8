#pragma once
// A formula's traction t = amplitude_k prod_j |x - e_j|^{p_j}, with amplitude_k on the panel between e_k and e_{k+1}.
// The value has the same type at every precision of the check, and a wrong variant can change it.

#include "numeric/cauchy/power_traction.hpp"
#include "proofs_checks/kit/values.hpp"

namespace steadyslide::proofs_checks {

/// The traction in the number type of a check.
// Not constrained, because g++ 12 does not accept constrained templates as template arguments.
template <class R>
struct PowerForm {
  R left_end;
  std::vector<R> lengths;
  std::vector<Exponent> exponents;  ///< exact
  std::vector<numeric::Power<R>> powers;
  std::vector<R> amplitudes;

  std::vector<R> points() const {
    std::vector<R> all{left_end};
    for (const R& length : lengths) all.push_back(all.back() + length);
    return all;
  }
  numeric::PowerTraction<R> traction() const {
    return {numeric::FundamentalSolution<R>(left_end, lengths, powers), amplitudes};
  }
};

struct PowerProduct {
  Number left_end;
  std::vector<Number> lengths;      ///< of the panels
  std::vector<Exponent> exponents;  ///< exact
  std::vector<Number> amplitudes;   ///< of the panels
  std::vector<Number> moved = {};   ///< near misses add these to the exponents

  /// Returns the product on exactly known points.
  static PowerProduct on(const std::vector<Rational>& points, std::vector<Exponent> exponents,
                         std::vector<Number> amplitudes) {
    PowerProduct product{to_real<Number>(points.front()), {}, std::move(exponents), std::move(amplitudes)};
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      product.lengths.push_back(to_real<Number>(points[k + 1] - points[k]));
    }
    return product;
  }

  void scale(const Number& factor) {
    for (Number& amplitude : amplitudes) amplitude *= factor;
  }
  void move_power(std::size_t j, const Number& step) {
    moved.resize(exponents.size());
    moved[j] += step;
  }

  template <Real R>
  PowerForm<R> at() const {
    PowerForm<R> form{
        R(left_end), {lengths.begin(), lengths.end()}, exponents, {}, {amplitudes.begin(), amplitudes.end()}};
    for (const Exponent& exponent : exponents) form.powers.push_back(numeric::Power<R>::of(exponent));
    for (std::size_t j = 0; j < moved.size(); ++j) {
      form.powers[j].value += R(moved[j]);
      form.powers[j].plus_one += R(moved[j]);
    }
    return form;
  }
};

}  // namespace steadyslide::proofs_checks
