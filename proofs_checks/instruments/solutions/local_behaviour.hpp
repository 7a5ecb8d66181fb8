#pragma once
// What a solved problem does at a distance d from a point of its contact set, d as small as one likes: the solver's
// points carry their distances, so that 1e-60 is as exact as 1/10. Limits and coefficients of logarithms are read off
// values of the traction at d, 2d and 4d. A power is not: the solver was given it, and would return it. What power the
// operator asks for is local_power.hpp's, that the solved traction satisfies the equation equation_error()'s.
//
// Lengths and tractions are the user's.

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

/// Throws Refutation unless a solution is found that meets every condition.
template <Real R>
Solved<R> solve(const ContactProblem& problem);

/// The point of the contact set at a place of the data. Throws Refutation if there is none.
template <Real R>
std::size_t point_at(const RiemannHilbertSolution<R>& solution, const Rational& place);
/// The outermost end of the contact.
template <Real R>
std::size_t contact_end(const RiemannHilbertSolution<R>& solution, Side side);
/// Is there contact next to the point, on this side?
template <Real R>
bool in_contact(const RiemannHilbertSolution<R>& solution, std::size_t point, Side side);

template <Real R>
SurfacePoint<R> beside(const TractionRepresentation<R>& form, std::size_t point, Side side, const R& d);
template <Real R>
R traction_beside(const RiemannHilbertSolution<R>& solution, std::size_t point, Side side, const R& d);
/// 10^-(digits + 10): t at such distances is its leading term to all digits, if the next one is a whole power smaller.
template <Real R>
R asymptotic_distance();

/// The problem solved in double: what trial.hpp's equation_error says of the solution. Throws Refutation unless one is found.
double equation_error(const ContactProblem& problem);

/// A of t ~ A + b d^p, whatever p > 0.
template <Real R>
R limit_beside(const RiemannHilbertSolution<R>& solution, std::size_t point, Side side);
/// K of t ~ K log(d)/pi.
template <Real R>
R logarithm_beside(const RiemannHilbertSolution<R>& solution, std::size_t point, Side side);

/// f'(x), by central differences of eighth order; `scale`: the distance to the next singular point.
template <Real R, class F>
R derivative(const F& f, const R& x, const R& scale) {
  using std::pow;
  const R h = scale * pow(R(10), -R(numeric::digits_served<R>) / 8 - 1);
  const auto difference = [&](int k) { return R(f(R(x + k * h)) - f(R(x - k * h))); };
  return (4 * difference(1) / 5 - difference(2) / 5 + 4 * difference(3) / 105 - difference(4) / 280) / h;
}

/// The problem of this name among those that the claims about convergence solve on cells.
ContactProblem cell_case(std::string_view name);
/// On cells, accepted by its certificate. Throws Refutation otherwise.
std::shared_ptr<const VariationalSolution> solve_on_cells(const ContactProblem& problem, std::size_t cells);
/// The power that the cells show on one side of a singular point.
Estimate<double> power_on_cells(const VariationalSolution& solution, const VariationalSolution::SingularPlace& place,
                                Side side);
/// Those of 8192 cells on both sides of its singular points of this kind: "left cells", "right cells", and the larger
/// "error bar".
Values powers_on_cells(const ContactProblem& problem, SingularKind kind);

}  // namespace steadyslide::proofs_checks
