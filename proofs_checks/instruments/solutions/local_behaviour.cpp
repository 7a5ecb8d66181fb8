#include "proofs_checks/instruments/solutions/local_behaviour.hpp"

#include <stdexcept>

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "proofs_checks/instruments/convergence/convergence_cases.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::ContactSet;

std::ptrdiff_t segment_beside(std::size_t point, Side side) {
  return static_cast<std::ptrdiff_t>(point) - (side == Side::left ? 1 : 0);
}

}  // namespace

template <Real R>
Solved<R> solve(const ContactProblem& problem) {
  const numeric::Attempt<R> attempt = numeric::riemann_hilbert<R>(problem);
  auto solution = std::dynamic_pointer_cast<const RiemannHilbertSolution<R>>(attempt.solution);
  if (!solution) throw Refutation{{"a problem to be solved", attempt.reason}};
  if (!solution->failed_condition().empty()) throw Refutation{{"a problem to be solved", solution->failed_condition()}};
  return solution;
}

template <Real R>
std::size_t point_at(const RiemannHilbertSolution<R>& solution, const Rational& place) {
  const auto& points = solution.form().set().points();
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (points[j].anchor && solution.problem().place(*points[j].anchor) == place) return j;
  }
  throw Refutation{{"x = " + to_string(place), "no point of the contact set"}};
}

template <Real R>
std::size_t contact_end(const RiemannHilbertSolution<R>& solution, Side side) {
  using Kind = typename ContactSet<R>::Kind;
  const ContactSet<R>& set = solution.form().set();
  return side == Side::left ? set.all(Kind::begins).front() : set.all(Kind::ends).back();
}

template <Real R>
bool in_contact(const RiemannHilbertSolution<R>& solution, std::size_t point, Side side) {
  const ContactSet<R>& set = solution.form().set();
  const std::ptrdiff_t k = segment_beside(point, side);
  return k >= 0 && k < static_cast<std::ptrdiff_t>(set.segments()) && set.in_contact(static_cast<std::size_t>(k));
}

template <Real R>
SurfacePoint<R> beside(const TractionRepresentation<R>& form, std::size_t point, Side side, const R& d) {
  return numeric::beside(form.set(), point, side, R(d / to_real<R>(form.problem().frame().unit)));
}

template <Real R>
R traction_beside(const RiemannHilbertSolution<R>& solution, std::size_t point, Side side, const R& d) {
  return solution.form().traction(beside(solution.form(), point, side, d)).value;
}

template <Real R>
R asymptotic_distance() {
  using std::pow;
  return pow(R(10), -(numeric::digits_served<R> + 10));
}

double equation_error(const ContactProblem& problem) { return equation_error(solve<double>(problem)->form()); }

template <Real R>
R limit_beside(const RiemannHilbertSolution<R>& solution, std::size_t point, Side side) {
  const R d = asymptotic_distance<R>();
  const R t[3] = {traction_beside(solution, point, side, d), traction_beside(solution, point, side, R(2 * d)),
                  traction_beside(solution, point, side, R(4 * d))};
  const R first = t[1] - t[0];
  const R second = t[2] - t[1];
  return t[0] - first * first / (second - first);
}

template <Real R>
R logarithm_beside(const RiemannHilbertSolution<R>& solution, std::size_t point, Side side) {
  using std::log;
  const R d = asymptotic_distance<R>();
  return numeric::pi<R>() *
         (traction_beside(solution, point, side, R(2 * d)) - traction_beside(solution, point, side, d)) / log(R(2));
}

ContactProblem cell_case(std::string_view name) {
  for (const ConvergenceCase& c : convergence_cases()) {
    if (c.name == name) return c.problem;
  }
  throw std::logic_error("no such case on cells");
}

std::shared_ptr<const VariationalSolution> solve_on_cells(const ContactProblem& problem, std::size_t cells) {
  const auto attempt = numeric::variational_inequality(problem, {.cells = cells});
  auto solution = std::dynamic_pointer_cast<const VariationalSolution>(attempt.solution);
  if (!solution) throw Refutation{{"a problem to be solved on cells", attempt.reason}};
  if (!solution->failed_condition().empty())
    throw Refutation{{"a problem to be solved on cells", solution->failed_condition()}};
  return solution;
}

Estimate<double> power_on_cells(const VariationalSolution& solution, const VariationalSolution::SingularPlace& place,
                                Side side) {
  using numeric::variational::PlaceIs;
  return numeric::variational::fitted_exponent(solution.cells(), place.surroundings, side, place.wedge_degree,
                                               place.exact ? PlaceIs::exact : PlaceIs::to_one_cell)
      .exponent;
}

Values powers_on_cells(const ContactProblem& problem, SingularKind kind) {
  Values values;
  double error_bar = 0;
  const auto solution = solve_on_cells(problem, 8192);
  for (const auto& place : solution->places()) {
    if (place.kind != kind) continue;
    for (const Side side : {Side::left, Side::right}) {
      const Estimate<double> power = power_on_cells(*solution, place, side);
      values.add({side == Side::left ? "left cells" : "right cells", Fitted{power.value, power.error}});
      error_bar = std::max(error_bar, power.error);
    }
  }
  values.add({"error bar", error_bar});
  return values;
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                \
  template Solved<R> solve(const ContactProblem&);                                                \
  template std::size_t point_at(const RiemannHilbertSolution<R>&, const Rational&);               \
  template std::size_t contact_end(const RiemannHilbertSolution<R>&, Side);                       \
  template bool in_contact(const RiemannHilbertSolution<R>&, std::size_t, Side);                  \
  template SurfacePoint<R> beside(const TractionRepresentation<R>&, std::size_t, Side, const R&); \
  template R traction_beside(const RiemannHilbertSolution<R>&, std::size_t, Side, const R&);      \
  template R asymptotic_distance();                                                               \
  template R limit_beside(const RiemannHilbertSolution<R>&, std::size_t, Side);                   \
  template R logarithm_beside(const RiemannHilbertSolution<R>&, std::size_t, Side);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::proofs_checks
