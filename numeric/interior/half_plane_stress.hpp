#pragma once
// Stresses in the half-plane z > 0 (x along the surface, z the depth) under tractions on z = 0: t is the normal
// traction, negative in compression; t_t is the component along +x of the traction that the indenter exerts on the
// body. The outward normal points to -z, so that on the surface
//
//   sigma_zz = t,   sigma_xz = -t_t,   sigma_xx = t + 2 H t_t,   H t_t = (1/pi) PV int t_t/(x'-x) dx'.
//
// Tension is positive. A force per unit of thickness (N, T) at the origin, N along the outward normal (negative in
// compression), T along +x, gives a radial field [Joh85, chapter 2]: with c = x/r, s = z/r,
//
//   (sigma_xx, sigma_zz, sigma_xz) = 2/(pi r) (N s - T c) (c^2, s^2, c s).
//
// The same in terms of C(zeta) = (1/pi) int t/(x'-zeta) dx' = 2i Phi(zeta), zeta = x + iz, and C_t made of t_t [Mus63]:
//
//   sigma_xx = Im C + 2 Re C_t + z (Re C' - Im C_t'),
//   sigma_zz = Im C            - z (Re C' - Im C_t'),
//   sigma_xz =    - Im C_t     - z (Im C' + Re C_t'),
//
// from 1/zeta = (x - iz)/r^2 and 1/zeta^2 = (x^2 - z^2 - 2ixz)/r^4. C tends to H t + i t at the surface (Plemelj), so
// that sigma_zz - t = z t_t' + O(z^2) and sigma_xz + t_t = -z (t' + 2 (H t_t)') + O(z^2) where t and t_t are smooth:
// these are the equations of equilibrium.

#include <cmath>

#include "numeric/cauchy/fundamental_solution.hpp"

namespace steadyslide::numeric {

template <Real R>
struct StressComponents {
  R xx;
  R zz;
  R xz;
};

/// Returns the stress of a force (normal, tangential) at (x, z), relative to the point of the force, z > 0.
template <Real R>
StressComponents<R> stress_of_force(const R& normal, const R& tangential, const R& x, const R& z) {
  const R r = sqrt(x * x + z * z);
  const R c = x / r;
  const R s = z / r;
  const R radial = 2 * (normal * s - tangential * c) / (pi<R>() * r);
  return {radial * c * c, radial * s * s, radial * c * s};
}

/// A Cauchy integral C and its derivative at a point.
template <Real R>
struct Potential {
  Complex<R> value;
  Complex<R> derivative;
};

template <Real R>
StressComponents<R> stress_of_potentials(const Potential<R>& normal, const Potential<R>& tangential, const R& z) {
  const R shift = z * (normal.derivative.re - tangential.derivative.im);
  return {normal.value.im + 2 * tangential.value.re + shift, normal.value.im - shift,
          -tangential.value.im - z * (normal.derivative.im + tangential.derivative.re)};
}

}  // namespace steadyslide::numeric
