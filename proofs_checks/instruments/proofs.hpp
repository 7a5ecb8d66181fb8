#pragma once
// Steps of the proofs of theorems 9 and 10 as claims, and the operator L they are made with. [Bal16, section 3]

#include "numeric/quadrature/trapezoidal.hpp"
#include "proofs_checks/instruments/near.hpp"
#include "proofs_checks/instruments/punch.hpp"

namespace steadyslide::proofs_checks {

Claim proof_decomposition();
Claim proof_splitting();
Claim proof_linear();
Claim proof_slope();
Claim proof_exclusion();
Claim proof_reduction();

/// v' on the panels of ]-1, 1[, panel by panel: a power of the distance to each end times a smooth function.
template <class R>
struct SlopePanel {
  R left;
  R length;
  numeric::Power<R> at_left;
  numeric::Power<R> at_right;
  std::function<R(const numeric::Node<R>&)> smooth;
};

/// L(v) = s v'/(1+s^2) - (1/(1+s^2)) W(x) (1/pi) PV int v'(x')/(W(x') (x'-x)) dx', W = (1+x)^{-(1/2+alpha)}
/// (1-x)^{-(1/2-alpha)}, by the trapezoidal rule. [Bal16, (10)]
template <Real R>
class Inverse {
 public:
  Inverse(const Rational& s, std::vector<SlopePanel<R>> slope);
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

/// (1+x)^{-rear} (1-x)^{-front} at a node of a panel, without the power of a panel end at -1 or 1.
template <Real R>
R inverse_weight(const Exponent& rear, const Exponent& front, const SlopePanel<R>& panel, const numeric::Node<R>& node,
                 bool whole);

/// t_0(x) with its distances to -1 and 1.
template <Real R>
R unit_solution(const Rational& s, const R& from_rear, const R& from_front);

}  // namespace steadyslide::proofs_checks
