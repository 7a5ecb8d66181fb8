#pragma once
// Enclosed stresses in the half-plane z > 0 under the tractions of a proved contact solution: x along the surface, z
// the depth, tension positive. On the surface sigma_zz = t and sigma_xz = -t_t, where t_t is the component along +x of
// the traction that the indenter exerts on the body. With zeta = x + iz [Mus63],
//
//   C(zeta) = (1/pi) int t/(x'-zeta) dx',   C_t(zeta) = (1/pi) int t_t/(x'-zeta) dx',
//
//   sigma_xx = Im C + 2 Re C_t + z (Re C' - Im C_t'),
//   sigma_zz = Im C            - z (Re C' - Im C_t'),
//   sigma_xz =    - Im C_t     - z (Im C' + Re C_t'),
//
// and W = Im C_t - Re C = (d u_z/dx - d u_x/dz) 2 mu/(kappa + 1), with mu and kappa of the half-space: twice the
// rotation.
//
// The weights 1/(x'-zeta)^n are analytic on panels that are not longer than their distance D from zeta. In the far
// ellipse, which reaches 0.8 L beyond the panel, they are at most (D - 0.8 L)^-n.

#include "enclosure/contact/enclosed_solution.hpp"

namespace steadyslide::enclosure {

struct StressComponents {
  Ball xx;
  Ball zz;
  Ball xz;
  Ball rotation;  ///< W
};

/// Returns the stresses at (x, z). Throws InvalidData unless z > 0.
StressComponents interior_stress(const EnclosedSolution& solution, const Rational& x, const Rational& z);

}  // namespace steadyslide::enclosure
