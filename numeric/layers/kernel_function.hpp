#pragma once
// An even or odd function on [-reach, reach] as Chebyshev series on panels, and its means over cells.

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
  /// Returns the mean over a cell of length h > 0 whose centre is y: its symbol is that of the function times
  /// sin(kh/2)/(kh/2). |y| + h/2 <= reach.
  R mean(const R& y, const R& h) const;
  /// Returns the mean of f(x' - x) over x and x' in two cells of length h > 0 whose centres differ by y: the symbol
  /// times the square of sin(kh/2)/(kh/2). |y| + h <= reach.
  R mean_of_cells(const R& y, const R& h) const;

 private:
  const Panel& panel_at(const R& y) const;
  /// Returns int_a^b (p + q (y - a)) f(y) dy, exact up to rounding.
  R integral(const R& a, const R& b, const R& p, const R& q) const;

  Parity parity_;
  std::vector<Panel> panels_;
};

}  // namespace steadyslide::numeric
