#pragma once
// The inverse of A for one friction value on ]-1, 1[, in the paper's form [Bal16, (10)],
//
//   L(u) = local u' - integral W(x) (1/pi) PV int u'(x')/(W(x') (x'-x)) dx',   W = (1+x)^rear (1-x)^front,
//
// Principal values are computed by quadrature. For a polynomial u' there is also the closed form of the values.

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

/// u' on one panel of ]-1, 1[: a power of the distance to each end times a smooth function.
template <class R>
struct SlopePanel {
  R left;
  R length;
  numeric::Power<R> at_left;
  numeric::Power<R> at_right;
  std::function<R(const Node<R>&)> smooth;
};

/// The two terms of L(u) at one point.
template <class R>
struct InverseTerms {
  R local;
  R integral;

  R sum() const { return local - integral; }
  /// Returns |L(u) - expected| divided by the largest of the two terms and `expected`.
  double difference(const R& expected) const;
};

template <Real R>
class InverseOperator {
 public:
  InverseOperator(const InverseFormula& formula, std::vector<SlopePanel<R>> slope);
  InverseOperator(const InverseFormula& formula, const Polynomial& slope);
  InverseOperator(const Rational& s, std::vector<SlopePanel<R>> slope)
      : InverseOperator(InverseFormula::of(s), std::move(slope)) {}

  /// Returns a point halfway between two samples, where a principal value needs no new samples.
  PanelPoint<R> point(std::size_t panel, const R& fraction) const { return grid_.midpoint_near(panel, fraction); }
  InverseTerms<R> terms(const PanelPoint<R>& at) const { return terms(at, grid_.hilbert(at)); }
  InverseTerms<R> terms_by_tanh_sinh(const PanelPoint<R>& at) const;
  R at(const PanelPoint<R>& at) const { return terms(at).sum(); }

 private:
  InverseTerms<R> terms(const PanelPoint<R>& at, const R& hilbert) const;

  InverseFormula formula_;
  std::vector<SlopePanel<R>> slope_;
  trapezoidal::Grid<R> grid_;  ///< samples of u'/W
};

/// Returns cos(pi alpha) W Q, where Q is the polynomial part at infinity of u' (z+1)^{1/2+alpha} (z-1)^{1/2-alpha}.
template <Real R>
JacobiTraction<R> inverse_without_integral(const Rational& s, const Polynomial& slope);

}  // namespace steadyslide::proofs_checks
