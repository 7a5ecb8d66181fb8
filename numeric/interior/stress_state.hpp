#pragma once
// The stress and the displacement gradient at a point of the body: x along the surface, z the depth, tension positive,
// u_x and u_z along +x and +z, in the user's units:
//
//   sigma_yy = nu (sigma_xx + sigma_zz) in plane strain, 0 in plane stress,
//   mean = (sigma_xx + sigma_yy + sigma_zz)/3,
//   von Mises = sqrt(((xx - yy)^2 + (yy - zz)^2 + (zz - xx)^2)/2 + 3 xz^2),
//   largest shear = sqrt(((xx - zz)/2)^2 + xz^2), half the difference of the principal stresses in the plane.
//
// The out-of-plane stress needs Poisson's ratio. For reduced data it is absent; then the invariants that contain it and
// the gradient are also absent.

#include <cmath>
#include <optional>

#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

/// The displacement gradient: d u_x/dx etc., without unit.
template <Real R>
struct DisplacementGradient {
  Estimate<R> x_x;  ///< d u_x/dx
  Estimate<R> x_z;  ///< d u_x/dz
  Estimate<R> z_x;  ///< d u_z/dx; on the surface it is -u' of contact problems
  Estimate<R> z_z;  ///< d u_z/dz
};

template <Real R>
struct StressState {
  Estimate<R> xx;
  Estimate<R> zz;
  Estimate<R> xz;
  std::optional<Estimate<R>> yy;
  std::optional<DisplacementGradient<R>> gradient;

  std::optional<Estimate<R>> mean() const {
    if (!yy) return std::nullopt;
    return (xx + *yy + zz) / R(3);
  }

  std::optional<Estimate<R>> von_mises() const {
    if (!yy) return std::nullopt;
    const auto norm = [](const R& a, const R& b, const R& c, const R& shear) {
      return R(sqrt((a * a + b * b + c * c) / 2 + 3 * shear * shear));
    };
    const R value = norm(xx.value - yy->value, yy->value - zz.value, zz.value - xx.value, xz.value);
    // The change of a norm is at most the norm of the change.
    const R error = norm(xx.error + yy->error, yy->error + zz.error, zz.error + xx.error, xz.error);
    return Estimate<R>{value, error + 8 * epsilon<R>() * value, xx.convergence};
  }

  Estimate<R> largest_shear() const {
    const auto norm = [](const R& a, const R& shear) { return R(sqrt(a * a / 4 + shear * shear)); };
    const R value = norm(xx.value - zz.value, xz.value), error = norm(xx.error + zz.error, xz.error);
    return {value, error + 4 * epsilon<R>() * value, xx.convergence};
  }
};

}  // namespace steadyslide::numeric
