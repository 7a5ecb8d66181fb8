#pragma once
// Stresses in the half-plane z > 0 under the tractions of a proved contact solution, enclosed: x as everywhere, z the depth,
// tension positive. On the surface sigma_zz = t and sigma_xz = -t_t, t_t the component along +x of what the indenter exerts
// on the body. With zeta = x + iz [Mus63],
//
//   C(zeta) = (1/pi) int t/(x'-zeta) dx',   C_t(zeta) = (1/pi) int t_t/(x'-zeta) dx',
//
//   sigma_xx = Im C + 2 Re C_t + z (Re C' - Im C_t'),
//   sigma_zz = Im C            - z (Re C' - Im C_t'),
//   sigma_xz =    - Im C_t     - z (Im C' + Re C_t'),
//
// and W = Im C_t - Re C = (d u_z/dx - d u_x/dz) 2 mu/(kappa + 1), the half-space's mu and kappa: the rotation, twice.
//
// The weights 1/(x'-zeta)^n are analytic on panels no longer than their distance D from zeta: in the far ellipse, which
// reaches 0.8 L beyond them, they are at most (D - 0.8 L)^-n.

#include "enclosure/contact/enclosed_solution.hpp"

namespace steadyslide::enclosure {

struct StressComponents {
  Ball xx;
  Ball zz;
  Ball xz;
  Ball rotation;  ///< W
};

/// At (x, z), z > 0. Throws InvalidData where z is not.
StressComponents interior_stress(const EnclosedSolution& solution, const Rational& x, const Rational& z);

}  // namespace steadyslide::enclosure
