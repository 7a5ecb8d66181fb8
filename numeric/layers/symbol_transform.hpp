#pragma once
// The integrals over all wave numbers that make kernels of symbols:
//
//   k_n(y) = int_0^oo (1 - W) sin(ky) dk,   gamma k_t(y) = int_0^oo (gamma - gamma V) cos(ky) dk.
//
// Both defects are Legendre series on panels, which are halved until the last coefficients are rounding errors. The
// integral of P_m(x) e^{i w x} is 2 i^m j_m(w) with a spherical Bessel function [AS, 10.1.14], so the work for one y
// does not depend on y.

#include <vector>

#include "numeric/layers/body_symbols.hpp"

namespace steadyslide::numeric {

/// Returns the relative error at which series end: epsilon, or 10^4 epsilon for the types with guard digits.
template <Real R>
R series_accuracy() {
  return epsilon<R>() * (std::same_as<R, double> ? 1 : 10000);
}

/// Returns the largest of the last three coefficients of two series of one length.
template <Real R>
R tail_of(const std::vector<R>& a, const std::vector<R>& b) {
  R largest = 0;
  for (std::size_t k = a.size() - 3; k < a.size(); ++k) largest = max(largest, R(max(abs(a[k]), abs(b[k]))));
  return largest;
}

/// True if a series is as exact as its values. Its tail is below the tolerance, or it comes from rounding, because it is
/// near the tolerance and hardly below `before`, the tail on a panel of twice the length.
template <Real R>
bool is_exact(const R& tail, const R& before, const R& tolerance) {
  return tail <= tolerance || (tail <= 1000 * tolerance && 4 * tail > before);
}

/// Removes the last coefficients of a series that are not above the tolerance, but not the first one.
template <Real R>
void drop_tail(std::vector<R>& series, const R& tolerance) {
  while (series.size() > 1 && abs(series.back()) <= tolerance) series.pop_back();
}

/// Writes j_0(x), j_1(x), ... for x > 0, as many as `result` has entries; errors are absolute.
template <Real R>
void spherical_bessel(const R& x, std::vector<R>& result);

template <Real R>
class SymbolTransform {
 public:
  /// Throws std::runtime_error if the panels become too many.
  explicit SymbolTransform(const BodySymbols<R>& symbols);

  struct Slopes {
    R normal;    ///< k_n
    R coupling;  ///< gamma k_t
  };
  /// Takes y > 0.
  Slopes at(const R& y) const;
  /// Returns N(0) of body_kernel.hpp.
  const R& normal_at_zero() const { return normal_at_zero_; }
  /// Returns the largest of |1 - W| and |gamma - gamma V| at the nodes.
  const R& largest_defect() const { return largest_; }

 private:
  struct Panel {
    R centre;
    R half;
    std::vector<R> normal;  ///< coefficients of P_m
    std::vector<R> coupling;
  };
  void add(const BodySymbols<R>& symbols, const R& left, const R& right, const R& tail_before);

  std::vector<Panel> panels_;
  R normal_at_zero_ = 0;
  R largest_ = 0;
};

}  // namespace steadyslide::numeric
