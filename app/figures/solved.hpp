#pragma once
// Problems of the figures, and their solutions by two independent solvers.

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "app/gnuplot/figure.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "numeric/variational/variational_solution.hpp"

namespace steadyslide::app {

/// A rigid flat punch on [-1, 1] under the load 1, E = 1, plane strain: lengths in units of L, tractions of P/L.
ContactProblem flat_punch(const Rational& poisson, std::vector<Rational> friction, std::vector<Rational> jumps = {},
                          Sliding sliding = Sliding::plus_x);

/// A rigid parabola psi = x^2/2 with the support [-1, 1], E = 1, plane strain, sliding to the right.
ContactProblem parabola(const Rational& poisson, std::vector<Rational> friction, const Rational& load,
                        std::vector<Rational> jumps = {});
/// Two rigid bumps psi = (x^2-1)^2/4 with the support [-2, 2] over a friction jump from 0.1 to 0.7 at 0, E = 1, nu =
/// 3/10.
ContactProblem two_bumps();

/// Solves by a closed form, or by the Riemann-Hilbert method if there is none. This and the next two functions throw
/// std::runtime_error if the problem is not solved.
std::shared_ptr<const numeric::ContactSolution<double>> solved(const ContactProblem& problem);
std::shared_ptr<const numeric::RiemannHilbertSolution<double>> solved_by_singular_functions(
    const ContactProblem& problem, const numeric::ContactSolution<double>* start = nullptr);
std::shared_ptr<const numeric::VariationalSolution> solved_on_cells(const ContactProblem& problem, std::size_t cells);

/// -t against x at `samples` places of each contact zone, with an interruption of the curve after each zone. Places
/// with infinite t are left out: the curve leaves the frame.
std::vector<Point> pressure_curve(const numeric::ContactSolution<double>& solution, int samples);
/// -t against x for every `step`th cell in contact.
std::vector<Point> pressure_of_cells(const numeric::VariationalSolution& solution, std::size_t step);

/// The effective friction of the solution by solved().
double effective_friction_of(const ContactProblem& problem);

/// Effective friction for both directions of sliding. For each direction there is a line over `places`, and marks by
/// the solver on 1000 cells at every `step`th place from `first_mark` on.
struct FrictionCurves {
  std::array<std::string, 2> legends;  ///< sliding to the right, to the left
  std::vector<Rational> places;
  std::function<ContactProblem(const Rational& place, Sliding sliding)> problem;
  std::size_t first_mark = std::numeric_limits<std::size_t>::max(), step = 1;
  std::function<double(const ContactProblem&)> effective_friction = effective_friction_of;
};
/// Returns line, marks, line, marks, in styles from `style` on.
std::vector<Series> friction_curves(const FrictionCurves& wanted, int style = 1);

/// "symbol = its exponent", with four decimals.
std::string exponent_text(const std::string& symbol, const numeric::SolvedSingularPoint<double>& point);

/// A decimal with `places` decimals, and with the minus sign of print.
std::string decimal(double value, int places);

}  // namespace steadyslide::app
