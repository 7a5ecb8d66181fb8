#pragma once
// The stress at a point of the body, tension positive, in the user's units:
//
//   sigma_yy = nu (sigma_xx + sigma_zz) in plane strain, 0 in plane stress,
//   mean = (sigma_xx + sigma_yy + sigma_zz)/3,
//   von Mises = sqrt(((xx - yy)^2 + (yy - zz)^2 + (zz - xx)^2)/2 + 3 xz^2).
//
// The out-of-plane stress needs Poisson's ratio: with reduced data it is absent, and the invariants with it.

#include <cmath>
#include <optional>

#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

template <Real R>
struct StressState {
  Estimate<R> xx;
  Estimate<R> zz;
  Estimate<R> xz;
  std::optional<Estimate<R>> yy;

  std::optional<Estimate<R>> mean() const {
    if (!yy) return std::nullopt;
    return (xx + *yy + zz) / R(3);
  }

  std::optional<Estimate<R>> von_mises() const {
    using std::sqrt;
    if (!yy) return std::nullopt;
    const R a = xx.value - yy->value;
    const R b = yy->value - zz.value;
    const R c = zz.value - xx.value;
    const R value = sqrt((a * a + b * b + c * c) / 2 + 3 * xz.value * xz.value);
    // No derivative is larger than 1, or sqrt 3 for the shear.
    const R error = xx.error + yy->error + zz.error + sqrt(R(3)) * xz.error + 8 * epsilon<R>() * value;
    return Estimate<R>{value, error, xx.convergence};
  }
};

}  // namespace steadyslide::numeric
