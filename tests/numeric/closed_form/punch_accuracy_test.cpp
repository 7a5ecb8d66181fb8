// Flat punches with 0, 1, 3 and 8 jumps, nu from -0.9 to 0.499 and f from 0 to 50. Load and equation are measured by
// the trapezoidal rule and, at a few points, by tanh-sinh and GSL.

#include "numeric/cauchy/residuals.hpp"
#include "numeric/closed_form/closed_form.hpp"
#include "numeric/quadrature/gsl_quadrature.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "support/numeric_test.hpp"

namespace {

/// Friction alternates between f and g, in pieces of unequal lengths.
ContactProblem punch(int jumps, const Rational& nu, const Rational& f, const Rational& g) {
  std::vector<Rational> values;
  std::vector<Rational> places;
  for (int k = 0; k <= jumps; ++k) values.push_back(k % 2 == 0 ? f : g);
  for (int k = 1; k <= jumps; ++k) places.push_back(Rational(2 * k * k + 3 * k, jumps * jumps + 5 * jumps + 4) - 1);
  return ContactProblem(Elasticity(Solid(nu, 1)), FrictionProfile(values, places), Indenter(-1, {{1, Polynomial()}}),
                        Rational(7, 3));
}

/// Poisson's ratio enters only through s. Without jumps there is only one s, so problems with the same s are measured
/// once.
template <Real R>
void check_residuals(int jumps, const R& tolerance,
                     const std::vector<const char*>& ratios = {"-0.9", "0", "0.3", "0.499"}) {
  using std::abs;
  std::set<std::vector<Rational>> measured;
  for (const char* nu : ratios) {
    for (const auto& [first, second] : {std::pair("0", "0"), {"0.5", "0.2"}, {"0", "50"}, {"50", "0.1"}, {"10", "3"}}) {
      const char *f = first, *g = second;
      INFO("jumps = ", jumps, ", nu = ", nu, ", f = ", f, ", g = ", g);
      const ContactProblem problem = punch(jumps, parse_rational(nu), parse_rational(f), parse_rational(g));
      std::vector<Rational> s;
      for (std::size_t k = 0; k < problem.friction().values().size(); ++k) s.push_back(problem.coupled_friction(k));
      if (!measured.insert(s).second) continue;
      const auto solution = closed_form<R>(problem).solution;
      const Residuals<R> residuals = solution->residuals();
      CHECK(residuals.equation <= tolerance);
      CHECK(residuals.load <= tolerance);
      CHECK(residuals.tension == 0);
      const Resultants<R> resultants = solution->resultants();
      CHECK(abs(resultants.normal.value * 3 / 7 - 1) <= tolerance);
      CHECK(resultants.normal.convergence == Convergence::reached);
    }
  }
}

}  // namespace

TEST_CASE("double: load and equation to 1e-12") {
  for (const int jumps : {0, 1, 3, 8}) check_residuals<double>(jumps, 1e-12);
}

TEST_CASE("50 digits: load and equation to 1e-45") {
  for (const int jumps : {0, 1}) check_residuals<Real50>(jumps, Real50("1e-45"));
  check_residuals<Real50>(3, Real50("1e-45"), {"-0.9"});
  const ContactProblem problem = punch(8, 0.3_r, 50, 0.1_r);
  const Residuals<Real50> residuals = closed_form<Real50>(problem).solution->residuals();
  CHECK(residuals.equation <= Real50("1e-45"));
  CHECK(residuals.load <= Real50("1e-45"));
}

TEST_CASE("100 digits: load and equation to 1e-95") {
  check_residuals<Real100>(0, Real100("1e-95"));
  check_residuals<Real100>(1, Real100("1e-95"), {"-0.9"});
  const ContactProblem problem = punch(3, -0.9_r, 50, 0.1_r);
  CHECK(closed_form<Real100>(problem).solution->residuals().equation <= Real100("1e-95"));
}

TEST_CASE("slow: all of them at 50 and 100 digits" * doctest::skip()) {
  for (const int jumps : {3, 8}) check_residuals<Real50>(jumps, Real50("1e-45"));
  for (const int jumps : {1, 3, 8}) check_residuals<Real100>(jumps, Real100("1e-95"));
}

TEST_CASE("GSL and tanh-sinh agree with the equation to 1e-11 where GSL converges") {
  int converged = 0, all = 0;
  for (const int jumps : {0, 1, 3, 8}) {
    for (const char* nu : {"-0.9", "0.3", "0.499"}) {
      const ContactProblem problem = punch(jumps, parse_rational(nu), 50, 0.5_r);
      const auto data = std::get<ClosedFormData<double>>(closed_form_data<double>(problem));
      const PiecewiseDensity<double> density = data.traction.density();
      for (std::size_t k = 0; k < density.size(); ++k) {
        const double s = to_real<double>(problem.coupled_friction(k));
        const Panel<double>& panel = density[k].panel;
        for (const double fraction : {1e-6, 0.3}) {
          for (const Node<double>& node :
               {panel.node_from_left(fraction * panel.length), panel.node_from_right(fraction * panel.length)}) {
            const double t = density[k](node), scale = std::max(std::abs(t), std::abs(s * t));
            CHECK(std::abs(tanh_sinh::hilbert(density, {k, node}).value + s * t) <= 1e-12 * scale);
            const Estimate<double> third = gsl::hilbert(density, {k, node});
            ++all;
            if (third.convergence != Convergence::reached) continue;
            ++converged;
            CHECK(std::abs(third.value + s * t) <= 1e-11 * scale);
          }
        }
      }
    }
  }
  CAPTURE(all);
  CHECK(converged > all / 2);
}

TEST_CASE("control: a swapped pair of friction values is refuted by the same residual") {
  const ContactProblem problem = punch(1, 0.3_r, 0.5_r, 0.2_r);
  const auto data = std::get<ClosedFormData<double>>(closed_form_data<double>(problem));
  const std::vector<double> swapped{to_real<double>(problem.coupled_friction(1)),
                                    to_real<double>(problem.coupled_friction(0))};
  const SurfaceCheck<double> check(data.traction.density(), swapped,
                                   [](std::size_t, const Node<double>&) { return 0.0; });
  CHECK(check.equation() > 1e-3);
}
