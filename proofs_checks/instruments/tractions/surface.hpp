#pragma once
// Checks that a traction satisfies A t = u'/c and carries the load: by the trapezoidal rule at many points of every
// panel, by tanh-sinh at some of them, and by GSL in double. The three routes share no rule, no nodes and no code.

#include <functional>

#include "model/contact_problem.hpp"
#include "proofs_checks/instruments/tractions/power_product.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {

template <Real R>
struct Surface {
  PiecewiseDensity<R> traction;
  std::vector<R> s;                  ///< per panel
  std::function<R(const R&)> slope;  ///< psi'/c
  R integral;                        ///< required value of int t
  R load_scale = 0;                  ///< smallest scale for the error of int t
};

/// Returns the surface under a traction: s from the friction pieces `first_piece`, ... of the problem, int t = -load.
template <Real R>
Surface<R> surface_of(
    const PowerForm<R>& form, const ContactProblem& problem, std::size_t first_piece,
    std::function<R(const R&)> slope = [](const R&) { return R(0); });

/// Checks load and equation, also at points that are 1e-6 of a panel away from its ends. `tanh_sinh_points` is the
/// number of points per case for tanh-sinh, spread over the panels; this route costs a hundred times as much as the
/// trapezoidal rule. Returns the samples of the trapezoidal rule.
template <Real R>
trapezoidal::Grid<R> check_surface(Findings& findings, const Surface<R>& surface, std::size_t tanh_sinh_points);

/// Checks load and equation by GSL to 1e-11. A value for which GSL does not converge is skipped.
void check_surface_by_gsl(Findings& findings, const Surface<double>& surface);

}  // namespace steadyslide::proofs_checks
