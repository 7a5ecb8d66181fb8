#pragma once
// The inverse of the operator under a constant friction coefficient, as the paper says it,
//
//   L(u) = local u' - integral W(x) (1/pi) PV int u'(x')/(W(x') (x'-x)) dx',   W = (1+x)^rear (1-x)^front,
//
// beside the closed form of its values for a polynomial u'. [Bal16, (10)]

#include "model/polynomial.hpp"
#include "numeric/quadrature/trapezoidal.hpp"
#include "proofs_checks/instruments/jacobi_traction.hpp"
#include "proofs_checks/kit/findings.hpp"
#include "proofs_checks/kit/values.hpp"

namespace steadyslide::proofs_checks {

struct InverseFormula {
  Number local;
  Number integral;
  Exponent rear;
  Exponent front;

  static InverseFormula of(const Rational& s);
};

/// L(u) on ]-1, 1[ by the formula, its principal values by quadrature.
template <class R>
class InverseByQuadrature {
 public:
  InverseByQuadrature(const InverseFormula& formula, const Polynomial& slope);

  /// Next to a fraction of the interval, where principal values by staggered nodes need no new samples.
  numeric::PanelPoint<R> point(int percent) const { return grid_.midpoint_near(0, R(percent) / 100); }
  /// |L(u) - expected| over the larger of the two terms and `expected`.
  double difference(const numeric::PanelPoint<R>& at, const R& expected) const;
  double difference_by_tanh_sinh(const numeric::PanelPoint<R>& at, const R& expected) const;

 private:
  double difference(const numeric::PanelPoint<R>& at, const R& hilbert, const R& expected) const;

  R local_;
  R integral_;
  std::vector<R> slope_;
  numeric::PanelDensity<R> weight_;
  numeric::trapezoidal::Grid<R> grid_;  ///< of u'/W
};

/// cos(pi alpha) W Q, Q the polynomial part at infinity of u' (z+1)^{1/2+alpha} (z-1)^{1/2-alpha}.
template <class R>
JacobiTraction<R> inverse_without_integral(const Rational& s, const Polynomial& slope);

}  // namespace steadyslide::proofs_checks
