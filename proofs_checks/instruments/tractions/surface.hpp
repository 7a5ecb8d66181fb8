#pragma once
// Does a traction satisfy A t = u'/c and carry the load? By the trapezoidal rule at many points of every panel, by
// tanh-sinh at some of them, and by GSL in double. The routes share no rule, no nodes and no code.

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
  R integral;                        ///< what int t has to be
  R load_scale = 0;                  ///< what its error is measured by if int t is smaller
};

/// The surface under a form: s from the friction pieces `first_piece`, ... of the problem, int t = -load.
template <Real R>
Surface<R> surface_of(
    const PowerForm<R>& form, const ContactProblem& problem, std::size_t first_piece,
    std::function<R(const R&)> slope = [](const R&) { return R(0); });

/// Load and equation, the points 1e-6 of a panel from its ends included. `tanh_sinh_points` per case, spread over the
/// panels: that route costs a hundred times the other one. Returns the samples of the other one.
template <Real R>
trapezoidal::Grid<R> check_surface(Findings& findings, const Surface<R>& surface, std::size_t tanh_sinh_points);

/// Load and equation by GSL, where it converges, to 1e-11.
void check_surface_by_gsl(Findings& findings, const Surface<double>& surface);

}  // namespace steadyslide::proofs_checks
