#pragma once
// A double-exponential rule for the unit interval, for functions that behave like log y at 0, are analytic at 1, and
// have no other singular point closer than 1 to the interval:
//
//   y = 1/(1 + e^{-2u}), u = (pi/2) sinh tau, the trapezoidal rule in tau [TM74].
//
// The step follows from the strip |Im tau| < 0.77 without singular points: the error is like e^{-2 pi 0.77/h}. The part
// of -int_0^1 log y dy below the first node is y (1 - log y), about epsilon.

#include <cmath>

#include "numeric/quadrature/jacobi_rule.hpp"

namespace steadyslide::numeric {

/// Nodes and weights for int_0^1 f(y) dy.
template <Real R>
UnitRule<R> double_exponential_rule() {
  const R digits = -log(epsilon<R>());
  const R h = 2 * pi<R>() * R(0.7) / digits;
  // -log y at the first node, with a margin for log y. -log(1 - y) at the last node is `digits`.
  const R left = digits + log(digits);
  const auto first = -static_cast<int>(ceil(asinh(left / pi<R>()) / h));
  const auto last = static_cast<int>(ceil(asinh(digits / pi<R>()) / h));
  UnitRule<R> rule;
  for (int i = first; i <= last; ++i) {
    const R tau = i * h;
    const R e = exp(-pi<R>() * sinh(tau));  // e^{-2u}
    const R y = 1 / (1 + e);
    const R rest = e < 1 ? R(e / (1 + e)) : R(1 / (1 + 1 / e));
    rule.from_left.push_back(y);
    rule.from_right.push_back(rest);
    rule.weights.push_back(h * pi<R>() * cosh(tau) * y * rest);
  }
  return rule;
}

}  // namespace steadyslide::numeric
