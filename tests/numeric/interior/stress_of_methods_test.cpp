// The stresses below the surface for every method's solution: compared with each other, with strips of constant
// traction, with the tractions at the surface, and with the gradient of a displacement.

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/interior/interior_stress_problems.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "numeric/variational/variational_solution.hpp"

using namespace steadyslide::numeric::stress_test;

namespace {

/// A parabola over a friction jump, and a punch over two.
ContactProblem coated_parabola() {
  return {body(), FrictionProfile({0.1_r, 0.6_r}, {0.1_r}), Indenter(-2, {{2, Polynomial({0, 0, 1})}}), 1};
}
ContactProblem coated_punch() {
  return {body(), FrictionProfile({0.1_r, 1, 0.3_r}, {-0.25_r, 0.5_r}), Indenter(-1, {{1, Polynomial()}}), 2};
}

double relative(const StressState<double>& a, const StressState<double>& b) {
  return difference(components(a), components(b)) / size(components(b));
}

const double field_places[][2] = {{0.1, 1e-9}, {0.1, 0.01}, {-0.3, 0.2}, {0.49, 1e-4},
                                  {0.02, 0.6}, {-3, 1},     {0, 20},     {1.5, 1e-6}};

}  // namespace

TEST_CASE("closed forms and the Riemann-Hilbert method have one field, point by point and many at a time") {
  for (const ContactProblem& problem : {coated_parabola(), coated_punch()}) {
    const InteriorStress<double> formula(*closed_form<double>(problem).solution);
    const InteriorStress<double> form(*riemann_hilbert<double>(problem).solution);
    const InteriorStress<Real50> exact(*closed_form<Real50>(problem).solution);
    std::vector<double> x, z;
    for (const auto& place : field_places) {
      x.push_back(place[0]);
      z.push_back(place[1]);
    }
    std::vector<StressState<double>> many(x.size());
    formula.at(x, z, many);
    for (std::size_t i = 0; i < x.size(); ++i) {
      CAPTURE(x[i]);
      CAPTURE(z[i]);
      CHECK(relative(formula.at(Rational(x[i]), Rational(z[i])), many[i]) == 0);
      CHECK(relative(form.at(Rational(x[i]), Rational(z[i])), many[i]) < 1e-12);
      errors_cover(many[i], exact.at(Rational(x[i]), Rational(z[i])));
      CHECK(many[i].xx.error < 1e-11 * size(components(many[i])));
    }
  }
}

TEST_CASE("tractions and slopes are recovered next to the surface, in double") {
  const double z = 1e-15;
  for (const bool formula : {true, false}) {
    for (const ContactProblem& problem : {coated_parabola(), coated_punch()}) {
      const auto solution = formula ? closed_form<double>(problem).solution : riemann_hilbert<double>(problem).solution;
      const auto slopes = riemann_hilbert<double>(problem).solution;
      const auto& form = dynamic_cast<const RiemannHilbertSolution<double>&>(*slopes);
      const InteriorStress<double> interior(*solution);
      for (const double x : {-0.2, 0.05, 0.3, 0.4}) {
        CAPTURE(x);
        const StressState<double> state = interior.at(Rational(x), Rational(z));
        const Sample<double> sample = solution->at(Rational(x));
        const double t = sample.traction.left.value;
        CHECK(std::abs(state.zz.value - t) < 1e-12 * std::abs(t));
        CHECK(std::abs(state.xz.value + sample.shear.left.value) < 1e-12 * std::abs(t));
        const double scale = std::abs(t) * to_real<double>(problem.elasticity().compliance());
        CHECK(std::abs(state.gradient->z_x.value + sample.slope.left.value) < 1e-12 * scale);
        CHECK(std::abs(state.gradient->x_x.value - form.tangential_slope(Rational(x)).value) < 1e-12 * scale);
        // Control: the surface turns in this direction, not in the other.
        CHECK(std::abs(state.gradient->x_z.value + sample.slope.left.value) > 1e-3 * scale);
      }
    }
  }
}

TEST_CASE("there is a displacement: its gradient's rows have no curl, in plane strain and plane stress") {
  using R = Real50;
  using std::abs;
  const Rational h = 1e-14_r;
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const ContactProblem problem(Elasticity(Solid(0.3_r, 2), plane), FrictionProfile({0.2_r, 0.7_r}, {0.1_r}),
                                 Indenter(-2, {{2, Polynomial({0, 0, 1})}}), 1);
    const InteriorStress<R> interior(*closed_form<R>(problem).solution);
    for (const auto& [x, z] : {std::pair(0.2_r, 0.3_r), {-0.6_r, 0.1_r}, {1, 0.5_r}}) {
      const auto gradient = [&, &x = x, &z = z](int dx, int dz) {
        return *interior.at(x + dx * h, z + dz * h).gradient;
      };
      const auto right = gradient(1, 0), left = gradient(-1, 0), down = gradient(0, 1), up = gradient(0, -1);
      const R step = 2 * to_real<R>(h);
      const R x_xz = (down.x_x.value - up.x_x.value) / step, x_zx = (right.x_z.value - left.x_z.value) / step;
      const R z_xz = (down.z_x.value - up.z_x.value) / step, z_zx = (right.z_z.value - left.z_z.value) / step;
      CHECK(abs(x_xz - x_zx) < R(1e-24));
      CHECK(abs(z_xz - z_zx) < R(1e-24));
      // Controls: x and z exchanged, as for a rotation in the opposite direction.
      const R reversed = (right.z_x.value - left.z_x.value) / step;
      CHECK(abs(x_xz - reversed) > R(1e-3));
      const auto here = gradient(0, 0);
      const StressState<R> stress = interior.at(x, z);
      const R shear = R(2) / (2 * R(13) / 10);  // E/(2 (1 + nu))
      CHECK(abs((here.x_z.value + here.z_x.value) * shear - stress.xz.value) < R(1e-45));
    }
  }
}

TEST_CASE("cells: strips of constant traction, one by one, at every depth; and the other methods' field") {
  const ContactProblem problem = coated_parabola();
  const auto found = variational_inequality(problem, {.cells = 2048}).solution;
  const auto& cells = dynamic_cast<const VariationalSolution&>(*found);
  const InteriorStress<double> interior(cells);
  const InteriorStress<double> formula(*closed_form<double>(problem).solution);
  const double jump = 0.1;
  for (const auto& place : field_places) {
    const double x = place[0], z = place[1];
    CAPTURE(x);
    CAPTURE(z);
    StressComponents<Real50> sum{0, 0, 0};
    const auto add_strip = [&](double a, double b, double p, double f) {
      if (a < b) add(sum, strip<Real50>(p, p * f, a, b, x, z));
    };
    const variational::Cells all = cells.cells();
    for (std::size_t i = 0; i < all.mean.size(); ++i) {
      const double left = all.edges[i], right = all.edges[i + 1], t = all.mean[i];
      if (t == 0) continue;
      const double middle = std::clamp(jump, left, right);
      add_strip(left, middle, -t, 0.1);
      add_strip(middle, right, -t, 0.6);
    }
    const StressState<double> state = interior.at(Rational(x), Rational(z));
    const double scale = size(components(state));
    CHECK(difference<Real50>({state.xx.value, state.zz.value, state.xz.value}, sum) < 1e-11 * scale);
    // Within a few cells of the jump, where the pressure is unbounded, the stresses of cells differ.
    if (z < 0.1) continue;
    const StressState<double> expected = formula.at(Rational(x), Rational(z));
    CHECK(difference(components(state), components(expected)) < 0.01 * scale);
    CHECK(std::abs(state.zz.value - expected.zz.value) <= state.zz.error);
  }
}

TEST_CASE("a hundred friction values: sums by moments are those of 50 digits") {
  std::vector<Rational> values, jumps;
  for (int k = 0; k < 100; ++k) {
    values.push_back(Rational(k % 7, 10));
    if (k > 0) jumps.push_back(Rational(2 * k - 100, 100) + Rational(k % 3, 1000));
  }
  const ContactProblem problem(body(), FrictionProfile(values, jumps), Indenter(-1, {{1, Polynomial()}}), 1);
  const InteriorStress<double> interior(*closed_form<double>(problem).solution);
  const InteriorStress<Real50> exact(*closed_form<Real50>(problem).solution);
  for (const auto& place : field_places) {
    CAPTURE(place[0]);
    CAPTURE(place[1]);
    const Rational x(place[0]), z(place[1]);
    const StressState<double> found = interior.at(x, z);
    const StressState<Real50> expected = exact.at(x, z);
    const StressComponents<Real50> sums{found.xx.value, found.zz.value, found.xz.value};
    CHECK(difference(sums, components(expected)) < 2e-13 * size(components(expected)));
    errors_cover(found, expected);
  }
}
