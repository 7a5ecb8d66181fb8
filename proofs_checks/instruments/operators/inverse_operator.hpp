#pragma once
// The inverse of A under one friction value on ]-1, 1[, as the paper says it [Bal16, (10)],
//
//   L(u) = local u' - integral W(x) (1/pi) PV int u'(x')/(W(x') (x'-x)) dx',   W = (1+x)^rear (1-x)^front,
//
// with principal values by quadrature; beside it the closed form of its values for a polynomial u'.

#include "model/polynomial.hpp"
#include "proofs_checks/instruments/tractions/jacobi_traction.hpp"
#include "proofs_checks/kit/values.hpp"

namespace steadyslide::proofs_checks {

struct InverseFormula {
  Number local;
  Number integral;
  Exponent rear;
  Exponent front;

  static InverseFormula of(const Rational& s);
};

/// u' on the panels of ]-1, 1[, panel by panel: a power of the distance to each end times a smooth function.
template <class R>
struct SlopePanel {
  R left;
  R length;
  numeric::Power<R> at_left;
  numeric::Power<R> at_right;
  std::function<R(const Node<R>&)> smooth;
};

/// L(u) at one point, by its terms.
template <class R>
struct InverseTerms {
  R local;
  R integral;

  R sum() const { return local - integral; }
  /// |L(u) - expected| over the larger of the two terms and `expected`.
  double difference(const R& expected) const;
};

template <Real R>
class InverseOperator {
 public:
  InverseOperator(const InverseFormula& formula, std::vector<SlopePanel<R>> slope);
  InverseOperator(const InverseFormula& formula, const Polynomial& slope);
  InverseOperator(const Rational& s, std::vector<SlopePanel<R>> slope)
      : InverseOperator(InverseFormula::of(s), std::move(slope)) {}

  /// Halfway between two samples, where principal values need no new ones.
  PanelPoint<R> point(std::size_t panel, const R& fraction) const { return grid_.midpoint_near(panel, fraction); }
  InverseTerms<R> terms(const PanelPoint<R>& at) const { return terms(at, grid_.hilbert(at)); }
  InverseTerms<R> terms_by_tanh_sinh(const PanelPoint<R>& at) const;
  R at(const PanelPoint<R>& at) const { return terms(at).sum(); }

 private:
  InverseTerms<R> terms(const PanelPoint<R>& at, const R& hilbert) const;

  InverseFormula formula_;
  std::vector<SlopePanel<R>> slope_;
  trapezoidal::Grid<R> grid_;  ///< of u'/W
};

/// cos(pi alpha) W Q, Q the polynomial part at infinity of u' (z+1)^{1/2+alpha} (z-1)^{1/2-alpha}.
template <Real R>
JacobiTraction<R> inverse_without_integral(const Rational& s, const Polynomial& slope);

}  // namespace steadyslide::proofs_checks
