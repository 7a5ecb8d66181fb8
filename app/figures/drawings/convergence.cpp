// The convergence of both solvers: on cells like a power of their number, with the rules of the Riemann-Hilbert method
// geometrically.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/figures/moment_rule.hpp"
#include "app/figures/solved.hpp"
#include "app/gnuplot/figure.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "proofs_checks/instruments/convergence/convergence_cases.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;
using Resultants = numeric::Resultants<double>;

constexpr std::size_t most_cells = 4096;

using Resultant = numeric::Estimate<double> Resultants::*;

/// Returns the root mean square of the errors for consecutive numbers of cells: so ends and jumps lie at many places
/// within a cell. It takes more of them if a free end dominates the error, because that error scatters with the place
/// in its cell.
double error_on_cells(const ContactProblem& problem, std::size_t cells, Resultant resultant, double exact,
                      double rate) {
  std::vector<double> errors;
  for (std::size_t n = cells; n < cells + (rate < 2 ? 7 : 21); ++n) {
    errors.push_back((solved_on_cells(problem, n)->resultants().*resultant).value - exact);
  }
  return checks::root_mean_square(errors);
}

/// The error of a case's resultant against the number of cells, and a line with the derived rate.
void add(Panel& panel, const std::string& name, const std::string& legend, Resultant resultant, int style) {
  const ContactProblem problem = checks::cell_case(name);
  const double exact = (solved(problem)->resultants().*resultant).value;
  const double rate = checks::expected_rate(problem, solved_on_cells(problem, most_cells)->places());
  Series marks{"", Look::marks, style, {}};
  std::vector<checks::Level> levels;
  for (std::size_t cells = 64; cells <= most_cells; cells *= 2) {
    const double error = error_on_cells(problem, cells, resultant, exact, rate);
    levels.push_back({static_cast<double>(cells), error});
    marks.points.push_back({static_cast<double>(cells), error});
  }
  marks.legend =
      fmt::format("{}: rate {}, derived {}", legend, decimal(checks::fitted_rate(levels).value, 2), decimal(rate, 0));
  // A line with the derived rate, through the middle of the measured errors.
  double mean = 0;
  for (const Point& p : marks.points) mean += std::log(p.y * std::pow(p.x, rate)) / double(marks.points.size());
  Series line{"", Look::line, style, {}};
  for (const double cells : {50.0, 5300.0}) {
    line.points.push_back({cells, std::exp(mean - rate * std::log(cells))});
  }
  panel.series.push_back(std::move(marks));
  panel.series.push_back(std::move(line));
}

}  // namespace

Figure make_convergence() {
  Panel cells{{0.1, 0.485, 0.33, 0.915},
              {"cells {/:Italic N}", 40, 6500, true},
              {"error of a resultant  (1; places: {/:Italic L})", 1e-8, 0.1, true}};
  cells.legend = LegendAt::below;
  add(cells, "jump-down", "friction jump", &Resultants::effective_friction, 2);
  add(cells, "step", "step", &Resultants::centre_of_pressure, 1);
  add(cells, "two-zones", "free ends", &Resultants::centre_of_pressure, 3);

  using R = numeric::Real50;
  const auto solution = std::dynamic_pointer_cast<const numeric::RiemannHilbertSolution<R>>(
      numeric::riemann_hilbert<R>(checks::cell_case("wedge-and-jump")).solution);
  if (!solution || !solution->failed_condition().empty()) throw std::runtime_error("a figure's problem is not solved");
  Panel rules{{0.6, 0.975, 0.33, 0.915},
              {"nodes {/:Italic n} of a rule", 0, 35, false, 5},
              {"relative error of an equation", 1e-52, 1, true}};
  Series condition{"moment ∫ {/:Italic h} = 0", Look::marks, 1, {}};
  Series load{"load ∫ {/:Italic xh} = −{/:Italic cP}", Look::marks, 2, {}};
  for (int n = 1; n <= 33; n += 2) {
    const MomentErrors errors = moment_errors(*solution, n);
    condition.points.push_back({double(n), static_cast<double>(errors.condition)});
    load.points.push_back({double(n), static_cast<double>(errors.load)});
  }
  const double at_34 = std::pow(3 + std::sqrt(8.0), -2 * 34.0);
  const Series bound{"derived rate (3 + √8)^{−2{/:Italic n}}", Look::line, 3, {{0, 1}, {34, at_34}}};
  rules.legend = LegendAt::below;
  rules.series = {condition, load, bound};
  return {
      "convergence",
      "How the two solvers converge",
      "Left: errors of the solver on `N` equal cells against the Riemann-Hilbert solution, root mean squares over "
      "neighbouring meshes: effective friction of a flat punch over a friction jump, centre of pressure of a "
      "parabola with a step, and of two bumps with free ends; lines with the derived rates. Right: what "
      "Gauss-Jacobi rules of `n` nodes a panel leave of the two equations of the Riemann-Hilbert method, the moment "
      "`int h = 0` and the load, for a wedge on a friction jump, at 50 digits; the line has the rate "
      "`(3+sqrt(8))^{-2n}` of panels no longer than their distance from singular points.",
      500,
      {cells, rules}};
}

}  // namespace steadyslide::app
