#pragma once
// An even or odd function on [-reach, reach] as Chebyshev series on panels.

#include <vector>

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

enum class Parity { even, odd };

template <Real R>
class KernelFunction {
 public:
  /// One panel, from the end of the panel before it.
  struct Panel {
    R left;
    R right;
    std::vector<R> series;  ///< coefficients of T_m(2 (y - left)/(right - left) - 1), at least one
  };
  /// Takes panels from 0 to the reach; no panels: the function is 0.
  KernelFunction(Parity parity, std::vector<Panel> panels) : parity_(parity), panels_(std::move(panels)) {}

  /// Returns the integral from 0, plus a constant if this function is odd.
  KernelFunction antiderivative(R at_zero) const;

  /// Returns the value at y, |y| <= reach.
  R at(const R& y) const;

 private:
  const Panel& panel_at(const R& y) const;

  Parity parity_;
  std::vector<Panel> panels_;
};

}  // namespace steadyslide::numeric
