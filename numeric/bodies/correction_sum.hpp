#pragma once
// The correction of a body's surface (surface_correction.hpp) under a traction. The forces on each part of the contact are
// replaced by forces at Chebyshev's points with the same integrals of polynomials. So few terms are left, because N and T
// are analytic around a part.

#include "numeric/layers/surface_correction.hpp"
#include "numeric/layers/surface_forces.hpp"
#include "numeric/number/estimate.hpp"
#include "numeric/solution/piecewise_traction.hpp"

namespace steadyslide::numeric {

class CorrectionSum {
 public:
  CorrectionSum(std::shared_ptr<const SurfaceCorrection<double>> correction, const PiecewiseTraction<double>& traction);

  /// Returns w = (1/pi) int t(x') [N'(x'-x) + f(x') T'(x'-x)] dx'.
  double slope(double x) const;
  /// Returns int w dx up to a constant: -(1/pi) int t(x') [N(x'-x) + f(x') T(x'-x)] dx'.
  double height(double x) const;
  /// Returns u/c on a body with absolute displacements, at a place on the right of the contact that is at least a part's
  /// length away from it.
  Estimate<double> absolute_on_the_right(double x, double gamma) const;

 private:
  std::shared_ptr<const SurfaceCorrection<double>> correction_;
  SurfaceForces forces_;  ///< t_t = -f t
  std::vector<double> places_;
};

}  // namespace steadyslide::numeric
