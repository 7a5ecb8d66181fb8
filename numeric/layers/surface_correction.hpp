#pragma once
// The difference between the surface of a body and that of the half-plane. A pressure p = -t displaces the surface
// downwards by
//
//   -u/c = (1/pi) int p(x') [-log|x-x'| + N(x'-x)] dx' + int^x s p dx' + (1/pi) int f(x') p(x') T(x'-x) dx',
//
// f > 0 if the indenter slides towards +x, f < 0 if towards -x. N is even and T is odd. Both are analytic on the real
// line. So the slopes satisfy
//
//   A t = u'/c + w,   w(x) = (1/pi) int t(x') [N'(x'-x) + f(x') T'(x'-x)] dx',
//
// with the half-plane's A and an analytic w, and singularities are those of the half-plane. docs/theory.md derives it.

#include <memory>
#include <optional>
#include <utility>

#include "model/contact_problem.hpp"
#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

/// N and T of a body, in the user's unit of length.
template <Real R>
class SurfaceCorrection {
 public:
  virtual ~SurfaceCorrection() = default;

  virtual R normal(const R& y) const = 0;          ///< N
  virtual R normal_slope(const R& y) const = 0;    ///< N'
  virtual R coupling(const R& y) const = 0;        ///< T; it contains gamma
  virtual R coupling_slope(const R& y) const = 0;  ///< T'
  /// Returns the distance from a real y to the nearest singularity of N and T in the complex plane.
  virtual R radius(const R& y) const = 0;
  /// Returns W and V of a wave number k > 0. V is 1 if gamma is 0.
  virtual std::pair<R, R> symbols(const R& k) const = 0;
  /// Returns L if N(y) - log|y| has the period L; absent otherwise.
  virtual std::optional<R> period() const { return std::nullopt; }
  /// True if N(y) - log|y| tends to 0 for large y, so that displacements are absolute: on a rigid base.
  virtual bool is_absolute() const { return false; }
};

/// Returns the correction of the problem's body for |y| <= reach; null for the half-plane.
template <Real R>
std::shared_ptr<const SurfaceCorrection<R>> surface_correction(const ContactProblem& problem, const R& reach);

}  // namespace steadyslide::numeric
