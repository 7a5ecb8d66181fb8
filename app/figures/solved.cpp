#include "app/figures/solved.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/variational_inequality.hpp"

namespace steadyslide::app {
namespace {

using Solution = numeric::ContactSolution<double>;

void check(const Solution* solution, const std::string& reason) {
  if (solution == nullptr) throw std::runtime_error("a figure's problem is not solved: " + reason);
  if (const std::string what = solution->failed_condition(); !what.empty()) {
    throw std::runtime_error("a figure's problem is not solved: " + what);
  }
}

}  // namespace

ContactProblem flat_punch(const Rational& poisson, std::vector<Rational> friction, std::vector<Rational> jumps,
                          Sliding sliding) {
  return {Elasticity(Solid(poisson, 1)), FrictionProfile(std::move(friction), std::move(jumps)),
          Indenter(-1, {{1, Polynomial()}}), 1, sliding};
}

ContactProblem parabola(const Rational& poisson, std::vector<Rational> friction, const Rational& load,
                        std::vector<Rational> jumps) {
  return {Elasticity(Solid(poisson, 1)), FrictionProfile(std::move(friction), std::move(jumps)),
          Indenter(-1, {{1, Polynomial({0, 0, Rational(1, 2)})}}), load};
}

ContactProblem two_bumps() {
  return {Elasticity(Solid(Rational(3, 10), 1)), FrictionProfile({Rational(1, 10), Rational(7, 10)}, {0}),
          Indenter(-2, {{2, Polynomial({Rational(1, 4), 0, Rational(-1, 2), 0, Rational(1, 4)})}}), 1};
}

std::shared_ptr<const Solution> solved(const ContactProblem& problem) {
  if (auto formula = numeric::closed_form<double>(problem).solution) return formula;
  return solved_by_singular_functions(problem);
}

std::shared_ptr<const numeric::RiemannHilbertSolution<double>> solved_by_singular_functions(
    const ContactProblem& problem, const Solution* start) {
  const numeric::Attempt<double> attempt = numeric::riemann_hilbert<double>(problem, start);
  check(attempt.solution.get(), attempt.reason);
  return std::dynamic_pointer_cast<const numeric::RiemannHilbertSolution<double>>(attempt.solution);
}

std::shared_ptr<const numeric::VariationalSolution> solved_on_cells(const ContactProblem& problem, std::size_t cells) {
  numeric::VariationalOptions options;
  options.cells = cells;
  const numeric::Attempt<double> attempt = numeric::variational_inequality(problem, options);
  check(attempt.solution.get(), attempt.reason);
  return std::dynamic_pointer_cast<const numeric::VariationalSolution>(attempt.solution);
}

std::vector<Point> pressure_curve(const Solution& solution, int samples) {
  std::vector<Point> curve;
  bool in_contact = false;
  for (const numeric::Sample<double>& sample : solution.samples(samples)) {
    const bool open = sample.gap && sample.gap->value > 0 && sample.traction.left.value == 0;
    if (open && in_contact) curve.push_back(gap_in_curve);
    in_contact = !open;
    if (open) continue;
    const double left = sample.traction.left.value;
    const double right = sample.traction.right.value;
    if (std::isfinite(left)) curve.push_back({sample.x, -left});
    if (std::isfinite(right) && right != left) curve.push_back({sample.x, -right});
  }
  return curve;
}

std::vector<Point> pressure_of_cells(const numeric::VariationalSolution& solution, std::size_t step) {
  const numeric::variational::Cells cells = solution.cells();
  std::vector<Point> points;
  for (std::size_t i = step / 2; i < cells.mean.size(); i += step) {
    if (cells.mean[i] != 0) points.push_back({(cells.edges[i] + cells.edges[i + 1]) / 2, -cells.mean[i]});
  }
  return points;
}

double effective_friction_of(const ContactProblem& problem) {
  return solved(problem)->resultants().effective_friction.value;
}

std::vector<Series> friction_curves(const FrictionCurves& wanted, int style) {
  std::vector<Series> result;
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    Series line{wanted.legends[result.size() / 2], Look::line, style, {}};
    Series marks{"", Look::marks, style++, {}};
    for (std::size_t k = 0; k < wanted.places.size(); ++k) {
      const ContactProblem problem = wanted.problem(wanted.places[k], sliding);
      const auto x = numeric::to_real<double>(wanted.places[k]);
      line.points.push_back({x, wanted.effective_friction(problem)});
      if (k < wanted.first_mark || (k - wanted.first_mark) % wanted.step != 0) continue;
      marks.points.push_back({x, solved_on_cells(problem, 1000)->resultants().effective_friction.value});
    }
    result.push_back(std::move(line));
    result.push_back(std::move(marks));
  }
  return result;
}

std::string exponent_text(const std::string& symbol, const numeric::SolvedSingularPoint<double>& point) {
  return symbol + " = " + decimal(numeric::to_real<double>(point.exponent.value()), 4);
}

std::string decimal(double value, int places) {
  const std::string text = fmt::format("{:.{}f}", std::abs(value), places);
  const bool negative = value < 0 && text.find_first_not_of("0.") != std::string::npos;
  return (negative ? "−" : "") + text;
}

}  // namespace steadyslide::app
