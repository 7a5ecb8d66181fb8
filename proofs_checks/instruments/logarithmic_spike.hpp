#pragma once
// Spikes that are as high as 1 and as small as one likes in H^{1/2}:
//
//   w_L(x) = min(1, log(1/|2x|)/L) for |x| < 1/2, 0 elsewhere:  1 for |x| < e^-L/2.
//
// Their energy, half of the double integral of (w(x)-w(y))^2/(x-y)^2 over pi on the whole line, is that of the harmonic
// extension, at most the extension min(1, log(1/|2z|)/L)'s, pi/L. Integrated by parts it is
//
//   -(1/pi) int int w'(x) w'(y) log|x-y| = (4/(pi L^2)) int_0^L (L-r) log coth(r/2) dr
//                                        = (4/(pi L^2)) (pi^2 L/4 - 7 zeta(3)/4 + 2 sum_{k odd} e^{-kL}/k^3).
//
// In double; distances only enter by their logarithms, so that any L will do.

#include "model/rational.hpp"

namespace steadyslide::proofs_checks {

double spike_energy(double l);
double spike_energy_by_quadrature(double l);
/// int t_0 w_L, t_0 of the friction s.
double spike_weight(const Rational& s, double l);

}  // namespace steadyslide::proofs_checks
