#include "proofs_checks/instruments/inverse_operator.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::Real100;
using numeric::Real50;

/// (1+x)^{-rear} (1-x)^{-front} at a node of a panel; if not `whole`, without the power of a panel end at -1 or 1.
template <Real R>
R inverse_weight(const Exponent& rear, const Exponent& front, const SlopePanel<R>& panel, const numeric::Node<R>& node,
                 bool whole) {
  using std::pow;
  R value = 1;
  if (whole || panel.left != -1) value *= pow(R(node.from_left + (panel.left + 1)), -numeric::to_real<R>(rear));
  const R rest = 1 - (panel.left + panel.length);
  const bool at_end = rest < panel.length * numeric::epsilon<R>() * 16;
  if (whole || !at_end) value *= pow(R(node.from_right + (at_end ? R(0) : rest)), -numeric::to_real<R>(front));
  return value;
}

template <Real R>
numeric::PiecewiseDensity<R> over_weight(const Exponent& rear, const Exponent& front,
                                         const std::vector<SlopePanel<R>>& slope) {
  numeric::PiecewiseDensity<R> density;
  for (std::size_t k = 0; k < slope.size(); ++k) {
    const SlopePanel<R>& panel = slope[k];
    // Where v' is smooth the weight brings the power of an end of ]-1, 1[.
    const auto left = k == 0 ? numeric::Power<R>::of(-rear) : panel.at_left;
    const auto right = k + 1 == slope.size() ? numeric::Power<R>::of(-front) : panel.at_right;
    density.push_back(
        {{panel.left, R(panel.left + panel.length), panel.length}, left, right, [=](const numeric::Node<R>& node) {
           return R(panel.smooth(node) * inverse_weight(rear, front, panel, node, false));
         }});
  }
  return density;
}

}  // namespace

template <Real R>
InverseOperator<R>::InverseOperator(const Rational& s, std::vector<SlopePanel<R>> slope)
    : s_(s),
      rear_(-(half + Exponent::angle(s))),
      front_(-(half - Exponent::angle(s))),
      slope_(std::move(slope)),
      grid_(over_weight(rear_, front_, slope_)) {}

template <Real R>
R InverseOperator<R>::at(const numeric::PanelPoint<R>& at) const {
  using std::pow;
  const SlopePanel<R>& panel = slope_[at.panel];
  R v = panel.smooth(at.node);
  if (panel.at_left.value != 0) v *= pow(at.node.from_left, panel.at_left.value);
  if (panel.at_right.value != 0) v *= pow(at.node.from_right, panel.at_right.value);
  const R weight = 1 / inverse_weight(rear_, front_, panel, at.node, true);
  const R s = numeric::to_real<R>(s_);
  return (s * v - weight * grid_.hilbert(at)) / (1 + s * s);
}

template class InverseOperator<double>;
template class InverseOperator<Real50>;
template class InverseOperator<Real100>;

}  // namespace steadyslide::proofs_checks
