#pragma once
// A traction t = amplitude_k prod_j |x - e_j|^{p_j}, amplitude_k on the panel between e_k and e_{k+1}, as a formula
// says it: a value of one type whatever the precision of the check, open to be changed by a wrong variant.

#include "proofs_checks/instruments/power_form.hpp"
#include "proofs_checks/kit/values.hpp"

namespace steadyslide::proofs_checks {

struct PowerProduct {
  Number left_end;
  std::vector<Number> lengths;      ///< of the panels
  std::vector<Exponent> exponents;  ///< exact
  std::vector<Number> amplitudes;   ///< of the panels
  std::vector<Number> moved = {};   ///< added to the exponents by near misses

  /// On exactly known points.
  static PowerProduct on(const std::vector<Rational>& points, std::vector<Exponent> exponents,
                         std::vector<Number> amplitudes);

  void scale(const Number& factor) {
    for (Number& amplitude : amplitudes) amplitude *= factor;
  }
  void move_power(std::size_t j, const Number& step) {
    moved.resize(exponents.size());
    moved[j] += step;
  }

  /// The same in the numbers of a check.
  template <Real R>
  PowerForm<R> at() const {
    PowerForm<R> form{R(left_end), {}, exponents, {}, {}};
    for (const Number& length : lengths) form.lengths.push_back(R(length));
    for (const Number& amplitude : amplitudes) form.amplitudes.push_back(R(amplitude));
    for (const Exponent& exponent : exponents) form.powers.push_back(numeric::Power<R>::of(exponent));
    for (std::size_t j = 0; j < moved.size(); ++j) form.move_power(j, R(moved[j]));
    return form;
  }
};

}  // namespace steadyslide::proofs_checks
