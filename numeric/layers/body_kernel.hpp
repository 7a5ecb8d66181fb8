#pragma once
// The kernels of a body's surface without the half-plane's own. A pressure p >= 0 displaces the surface downwards by
//
//   -u/c = (1/pi) int p(x') [-log|x - x'| + N(x' - x)] dx' + int^x s p dx' + (1/pi) int +-f(x') p(x') T(x' - x) dx',
//
//   N even, N'(y) = k_n(y) = int_0^oo (1 - W) sin(ky) dk,
//   T odd,  T'(y) = gamma k_t(y) = int_0^oo (gamma - gamma V) cos(ky) dk,
//
// with s = +-gamma f as in model/contact_problem.hpp, W and V of body_symbols.hpp. If W(0) = 0, as on a rigid base, N
// is normalised so that N(y) - log|y| tends to 0: the displacement is absolute. Otherwise N(0) = 0 and N grows like
// (1 - W(0)) log|y|. T tends to +-(pi/2) gamma (1 - V(0)). On a bonded layer on a rigid base this cancels the
// half-plane's term up to half of the total: int^x s p - (1/2) int s p is the coupled displacement far from the load.
//
// The functions are Chebyshev series on panels that grow with the distance. Errors are a few epsilon of the larger of 1
// and the largest |N|, and 50 digits for Real50, up to a reach of a thousand thicknesses of the first layer. If moduli of
// layers differ by factors near 10^8, three digits fewer.

#include "numeric/layers/body_symbols.hpp"
#include "numeric/layers/kernel_function.hpp"

namespace steadyslide::numeric {

template <Real R>
class BodyKernel {
 public:
  /// The functions can be evaluated for |y| <= reach. Throws std::invalid_argument unless reach > 0,
  /// std::runtime_error if a series does not converge.
  BodyKernel(const BodySymbols<R>& symbols, const R& reach);

  /// Returns N.
  const KernelFunction<R>& normal() const { return normal_; }
  /// Returns k_n = N'.
  const KernelFunction<R>& normal_slope() const { return normal_slope_; }
  /// Returns T.
  const KernelFunction<R>& coupling() const { return coupling_; }
  /// Returns gamma k_t = T'.
  const KernelFunction<R>& coupling_slope() const { return coupling_slope_; }
  /// True if the displacement is absolute.
  bool is_absolute() const { return absolute_; }

 private:
  struct Slopes;
  explicit BodyKernel(const Slopes& slopes);

  KernelFunction<R> normal_slope_;
  KernelFunction<R> coupling_slope_;
  KernelFunction<R> normal_;
  KernelFunction<R> coupling_;
  bool absolute_;
};

}  // namespace steadyslide::numeric
