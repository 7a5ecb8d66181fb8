#pragma once
// Measures a solved problem at a distance d from a point of its contact set, for arbitrarily small d: the solver's
// points carry their distances, so that 1e-60 is as exact as 1/10. Limits and coefficients of logarithms come from
// values of the traction at d, 2d and 4d. A power is not measured in this way: the solver uses it as an input and would
// return it. local_power.hpp finds the power from the operator, and equation_error() checks that the solved traction
// satisfies the equation.
//
// Lengths and tractions are in the user's units.

#include <memory>

#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "numeric/variational/variational_solution.hpp"
#include "proofs_checks/kit/findings.hpp"
#include "proofs_checks/kit/values.hpp"

namespace steadyslide::proofs_checks {

using numeric::RiemannHilbertSolution;
using numeric::SurfacePoint;
using numeric::TractionRepresentation;
using numeric::VariationalSolution;

template <Real R>
using Solved = std::shared_ptr<const RiemannHilbertSolution<R>>;

/// Returns a solution that meets every condition. Throws Refutation if there is none.
template <Real R>
Solved<R> solve(const ContactProblem& problem);

/// Returns the point of the contact set at a point of the problem's data. Throws Refutation if there is none.
template <Real R>
std::size_t point_at(const RiemannHilbertSolution<R>& solution, const Rational& place);
/// Returns the outermost contact end on this side.
template <Real R>
std::size_t contact_end(const RiemannHilbertSolution<R>& solution, Side side);
/// True if there is contact close to the point on this side.
template <Real R>
bool in_contact(const RiemannHilbertSolution<R>& solution, std::size_t point, Side side);

template <Real R>
SurfacePoint<R> beside(const TractionRepresentation<R>& form, std::size_t point, Side side, const R& d);
template <Real R>
R traction_beside(const RiemannHilbertSolution<R>& solution, std::size_t point, Side side, const R& d);
/// Returns 10^-(digits + 10). At such distances t equals its leading term to all digits if the next term is smaller by
/// a whole power.
template <Real R>
R asymptotic_distance();

/// Solves the problem in double and returns equation_error() (trial.hpp) of its solution. Throws Refutation if there is
/// no solution.
double equation_error(const ContactProblem& problem);

/// Returns A in t ~ A + b d^p, for any p > 0.
template <Real R>
R limit_beside(const RiemannHilbertSolution<R>& solution, std::size_t point, Side side);
/// Returns K in t ~ K log(d)/pi.
template <Real R>
R logarithm_beside(const RiemannHilbertSolution<R>& solution, std::size_t point, Side side);

/// Returns f'(x) by central differences of eighth order. `scale` is the distance to the next singular point.
template <Real R, class F>
R derivative(const F& f, const R& x, const R& scale) {
  using std::pow;
  const R h = scale * pow(R(10), -R(numeric::digits_served<R>) / 8 - 1);
  const auto difference = [&](int k) { return R(f(R(x + k * h)) - f(R(x - k * h))); };
  return (4 * difference(1) / 5 - difference(2) / 5 + 4 * difference(3) / 105 - difference(4) / 280) / h;
}

/// Returns the problem of this name from convergence_cases().
ContactProblem cell_case(std::string_view name);
/// Returns the solution on cells if its certificate accepts it. Throws Refutation otherwise.
std::shared_ptr<const VariationalSolution> solve_on_cells(const ContactProblem& problem, std::size_t cells);
/// Returns the exponent fitted to the cells on one side of a singular point.
Estimate<double> power_on_cells(const VariationalSolution& solution, const VariationalSolution::SingularPlace& place,
                                Side side);
/// Returns the exponents fitted to 8192 cells on both sides of the singular points of this kind: "left cells", "right
/// cells", and the largest "error bar".
Values powers_on_cells(const ContactProblem& problem, SingularKind kind);

}  // namespace steadyslide::proofs_checks
