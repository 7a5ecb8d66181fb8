// The fields of a force, and the same through potentials, are compared with the closed forms for a uniform strip. The
// stresses below the surface consist of these fields.

#include "numeric/interior/interior_stress_problems.hpp"
#include "numeric/quadrature/jacobi_rule.hpp"

using namespace steadyslide::numeric::stress_test;

namespace {

/// C of a uniform traction on [-a, a]: log((zeta - a)/(zeta + a))/pi times the traction.
template <Real R>
Potential<R> strip_potential(const R& a, const R& x, const R& z, const R& traction) {
  using std::atan2, std::log;
  const R right = (x - a) * (x - a) + z * z, left = (x + a) * (x + a) + z * z;
  const R f = traction / pi<R>();
  // C' = (1/(zeta - a) - 1/(zeta + a))/pi.
  return {{f * log(right / left) / 2, f * (atan2(z, R(x - a)) - atan2(z, R(x + a)))},
          {f * ((x - a) / right - (x + a) / left), f * (-z / right + z / left)}};
}

const double places[][2] = {{0, 0.5}, {0.3, 0.2}, {-1.4, 0.7}, {2, 0.125}, {-0.9, 3}};

}  // namespace

TEST_CASE_TEMPLATE("potentials and a sum of forces give a strip's field, and neither sign may be reversed", R, double,
                   Real50) {
  const R a = 1, t = -2, shear = R(3) / 4;
  JacobiRules<R> rules;
  const UnitRule<R>& rule = rules.get({R(0), R(1)}, {R(0), R(1)}, std::same_as<R, double> ? 400 : 1200);
  for (const auto& place : places) {
    const R x = place[0], z = place[1];
    CAPTURE(place[0]);
    const StressComponents<R> expected = strip<R>(-t, shear, -a, a, x, z);
    const R tolerance = 400 * epsilon<R>() * size(expected);
    const Potential<R> normal = strip_potential(a, x, z, t);
    CHECK(difference(stress_of_potentials(normal, strip_potential(a, x, z, shear), z), expected) < tolerance);
    CHECK(difference(stress_of_potentials(normal, strip_potential(a, x, z, R(-shear)), z), expected) > R(0.01));
    StressComponents<R> sum{R(0), R(0), R(0)};
    StressComponents<R> reversed = sum;
    for (std::size_t i = 0; i < rule.size(); ++i) {
      const R w = 2 * a * rule.weights[i], from = x + a - 2 * a * rule.from_left[i];
      for (const int sign : {1, -1}) {
        add(sign == 1 ? sum : reversed, stress_of_force<R>(w * t, sign * w * shear, from, z));
      }
    }
    CHECK(difference(sum, expected) < 10 * tolerance);
    CHECK(difference(reversed, expected) > R(0.01));
  }
}

TEST_CASE("a narrow strip is a force, to the square of its width") {
  using R = Real50;
  const R x = R(3) / 10, z = R(2) / 5;
  const auto error = [&](const R& a, const R& factor) {
    const StressComponents<R> force = stress_of_force<R>(R(-2) * factor, R(3) / 4, x, z);
    return R(difference(strip<R>(1 / a, 3 / (8 * a), -a, a, x, z), force) / size(force));
  };
  const R wide = error(R("1e-6"), R(1)), narrow = error(R("1e-8"), R(1));
  CHECK(wide < R("1e-10"));
  CHECK(static_cast<double>(R(wide / narrow)) == doctest::Approx(1e4).epsilon(1e-3));
  // Control: a changed factor.
  CHECK(error(R("1e-8"), R(2)) > R(0.1));
}
