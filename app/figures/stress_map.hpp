#pragma once
// What the map of stresses is made of, for its test.

#include "numeric/interior/interior_stress.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"

namespace steadyslide::app {

/// The flat punch with two coatings under the map.
ContactProblem stress_map_problem();

/// The limit of the stresses at a place of the surface that is no singular point, without error estimates: sigma_zz =
/// t, sigma_xz = -t_t, sigma_xx = (1 - 2 gamma) t + 2 u_t'/c.
numeric::StressState<double> surface_stress(const numeric::RiemannHilbertSolution<double>& solution,
                                            const ContactProblem& problem, double x);

/// The largest difference of sigma_zz and sigma_xz at the depth z from these, 0.25 away from the singular points.
double surface_error(const numeric::RiemannHilbertSolution<double>& solution, const ContactProblem& problem,
                     const Rational& z);

}  // namespace steadyslide::app
