#pragma once
// A value with its error. In sums, differences, products and quotients the errors add to first order,
//
//   error(a +- b) = error(a) + error(b),
//   error(a b) = |b| error(a) + |a| error(b),   error(a/b) = (error(a) + |a/b| error(b))/|b|,
//
// and `stalled` is kept. The rounding of a single operation is not included, because estimates are much larger.

#include <cmath>

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

enum class Convergence { reached, stalled };

/// The value, an estimate (not a bound) of its absolute error, and the convergence of the method. In an operation with
/// an estimate, a plain number is exact.
template <Real R>
struct Estimate {
  R value = 0;
  R error = 0;
  Convergence convergence = Convergence::reached;

  Estimate& operator+=(const Estimate& term) {
    value += term.value;
    error += term.error;
    if (term.convergence == Convergence::stalled) convergence = Convergence::stalled;
    return *this;
  }
  Estimate& operator*=(const R& factor) {
    value *= factor;
    error *= abs(factor);
    return *this;
  }

  friend Estimate operator-(Estimate a) { return {-a.value, a.error, a.convergence}; }
  friend Estimate operator+(Estimate a, const Estimate& b) { return a += b; }
  friend Estimate operator-(Estimate a, const Estimate& b) { return a += -b; }
  friend Estimate operator*(const R& factor, Estimate a) { return a *= factor; }
  friend Estimate operator/(const Estimate& a, const R& divisor) {
    return {a.value / divisor, a.error / abs(divisor), a.convergence};
  }
  friend Estimate operator*(const Estimate& a, const Estimate& b) {
    return {a.value * b.value, abs(b.value) * a.error + abs(a.value) * b.error, worse(a, b)};
  }
  friend Estimate operator/(const Estimate& a, const Estimate& b) {
    const R quotient = a.value / b.value;
    const R size = abs(b.value);
    return {quotient, a.error / size + b.error / size * abs(quotient), worse(a, b)};
  }

  /// Returns the same value with its error increased by `relative` times its size.
  Estimate widened(const R& relative) const { return {value, error + relative * abs(value), convergence}; }

 private:
  static Convergence worse(const Estimate& a, const Estimate& b) {
    return a.convergence == Convergence::stalled ? a.convergence : b.convergence;
  }
};

}  // namespace steadyslide::numeric
