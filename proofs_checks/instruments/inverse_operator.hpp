#pragma once
// The inverse of A under one friction value on ]-1, 1[, by the trapezoidal rule [Bal16, (10)]:
//
//   L(v) = s v'/(1+s^2) - (1/(1+s^2)) W(x) (1/pi) PV int v'(x')/(W(x') (x'-x)) dx',
//   W = (1+x)^{-(1/2+alpha)} (1-x)^{-(1/2-alpha)}

#include "numeric/quadrature/trapezoidal.hpp"

namespace steadyslide::proofs_checks {

using numeric::Real;

/// v' on the panels of ]-1, 1[, panel by panel: a power of the distance to each end times a smooth function.
template <class R>
struct SlopePanel {
  R left;
  R length;
  numeric::Power<R> at_left;
  numeric::Power<R> at_right;
  std::function<R(const numeric::Node<R>&)> smooth;
};

template <Real R>
class InverseOperator {
 public:
  InverseOperator(const Rational& s, std::vector<SlopePanel<R>> slope);
  /// Halfway between two samples.
  numeric::PanelPoint<R> point(std::size_t panel, const R& fraction) const {
    return grid_.midpoint_near(panel, fraction);
  }
  R at(const numeric::PanelPoint<R>& at) const;

 private:
  Rational s_;
  Exponent rear_;
  Exponent front_;
  std::vector<SlopePanel<R>> slope_;
  numeric::trapezoidal::Grid<R> grid_;
};

}  // namespace steadyslide::proofs_checks
