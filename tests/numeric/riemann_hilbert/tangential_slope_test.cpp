// u_t', the slope of the tangential displacement, computed in two ways: by the form, which has no principal value, and
// by the trapezoidal rule on t_t = -+f t [Bal16, (2)].

#include "numeric/interior/interior_stress_problems.hpp"
#include "numeric/quadrature/trapezoidal.hpp"
#include "support/solved_contact.hpp"

namespace {

template <Real R>
void agree(Sliding sliding) {
  using std::abs;
  const R tolerance = 2000 * epsilon<R>();
  const ContactProblem p = stress_test::jumps(sliding);
  const stress_test::Solved<R> solved(p);
  const RiemannHilbertSolution<R>& solution = solved.solution;
  const TractionRepresentation<R>& form = solution.form();
  const ContactSet<R>& set = form.set();
  const Frame& frame = form.problem().frame();

  const PiecewiseDensity<R> normal = traction_density(form);
  PiecewiseDensity<R> shear;
  for (std::size_t k = 0; k < set.segments(); ++k) {
    if (!set.in_contact(k)) continue;
    const R f = to_real<R>(p.friction().values()[form.friction_at(k)]);
    shear.push_back(scaled<R>(normal[shear.size()], sliding == Sliding::plus_x ? R(-f) : f));
  }
  const trapezoidal::Grid<R> grid(std::move(shear));
  const R c = to_real<R>(p.elasticity().compliance()), gamma = to_real<R>(p.elasticity().gamma());
  R scale = 0;
  std::vector<R> differences;
  for (std::size_t k = 0; k < normal.size(); ++k) {
    for (const char* part : {"1/1000", "1/7", "5/8", "999/1000"}) {
      const R fraction = to_real<R>(parse_rational(part));
      const Panel<R>& panel = grid.density()[k].panel;
      const R xi = panel.left + fraction * panel.length;
      // Both use exactly the same place.
      const Rational x = frame.origin + frame.unit * Rational(static_cast<double>(xi));
      const R exact = to_real<R>((x - frame.origin) / frame.unit);
      const Node<R> node{exact, R(exact - panel.left), R(panel.right - exact)};
      const R t = normal[k](node);
      const R expected = c * (grid.hilbert({k, node}) + gamma * t);
      const Estimate<R> found = solution.tangential_slope(x);
      CHECK(found.convergence == Convergence::reached);
      scale = std::max(scale, R(abs(expected)));
      differences.push_back(R(abs(found.value - expected)));
      // Control: without gamma t the two differ.
      CHECK(abs(found.value - (expected - c * gamma * t)) > 1000 * tolerance * abs(expected));
    }
  }
  for (const R& difference : differences) CHECK(difference <= tolerance * scale);

  const R beyond = grid.cauchy(Side::right, R(1) / 8);
  const R end = solution.contact().back().right.x.value;
  const Rational x(static_cast<double>(R(end + to_real<R>(frame.unit) / 8)));
  CHECK(abs(solution.tangential_slope(x).value - c * beyond) <= 1e-14 * c * abs(beyond));
}

}  // namespace

TEST_CASE("the tangential displacement's slope, sliding both ways") {
  agree<double>(Sliding::plus_x);
  agree<double>(Sliding::minus_x);
  agree<Real50>(Sliding::minus_x);
}
