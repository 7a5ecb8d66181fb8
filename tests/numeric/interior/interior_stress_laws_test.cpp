// Laws of the stresses below the surface, independent of the formula: equilibrium, the tractions at the surface, the
// resultants far away.

#include "numeric/interior/interior_stress_problems.hpp"

using namespace steadyslide::numeric::stress_test;

namespace {

using R = Real50;

const Rational millionth(1, 1000000);

double as_double(const R& x) { return static_cast<double>(x); }

}  // namespace

TEST_CASE("equilibrium and compatibility, by differences") {
  using std::abs;
  const Solved<R> solved(corners());
  const Rational h = 1_r / 1000000000000_r;
  for (const double fraction : {-0.2, 0.1, 0.5, 0.9}) {
    const Rational x = solved.place(fraction), z(1, 7);
    const auto at = [&](int dx, int dz) { return components(solved.interior.at(x + dx * h, z + dz * h)); };
    const auto here = at(0, 0), left = at(-1, 0), right = at(1, 0), up = at(0, -1), down = at(0, 1);
    const R step = 2 * to_real<R>(h);
    const R xx_x = (right.xx - left.xx) / step, xz_x = (right.xz - left.xz) / step;
    const R xz_z = (down.xz - up.xz) / step, zz_z = (down.zz - up.zz) / step;
    const R scale = abs(xx_x) + abs(xz_x) + abs(xz_z) + abs(zz_z);
    CHECK(abs(xx_x + xz_z) < R(1e-18) * scale);
    CHECK(abs(xz_x + zz_z) < R(1e-18) * scale);
    const auto laplacian = [&](auto part) {
      return R((part(left) + part(right) + part(up) + part(down) - 4 * part(here)) * 4 / (step * step));
    };
    const R sum = laplacian([](const auto& s) { return R(s.xx + s.zz); });
    const R one = laplacian([](const auto& s) { return s.zz; });
    CHECK(abs(sum) < R(1e-12) * abs(one));
    // Controls: the shear stress reversed; a single normal stress is not harmonic (above).
    CHECK(abs(xx_x - xz_z) > R(0.01) * scale);
    CHECK(abs(one) > R(0.01));
  }
}

// Slow: 12 s at 50 digits, for depths down to 1e-8 of the contact's length.
TEST_CASE("slow: the tractions are reached at the surface, at the rate that equilibrium tells" * doctest::skip()) {
  using std::abs;
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    for (const ContactProblem& problem : {jumps(sliding), corners(sliding), punch(sliding)}) {
      const Solved<R> solved(problem);
      const RiemannHilbertSolution<R>& solution = solved.solution;
      const R gamma = to_real<R>(problem.elasticity().gamma());
      const R c = to_real<R>(problem.elasticity().compliance());
      const auto surface = [&](const Rational& x) {
        const Sample<R> s = solution.at(x);
        const R t = s.traction.left.value;
        return StressComponents<R>{(1 - 2 * gamma) * t + 2 * solution.tangential_slope(x).value / c, t,
                                   -s.shear.left.value};
      };
      for (const double fraction : {0.15, 0.4, 0.85}) {
        CAPTURE(fraction);
        const Rational x = solved.place(fraction);
        const StressComponents<R> limit = surface(x);
        const Rational dx(1, 1000000000);
        const StressComponents<R> before = surface(x - dx), behind = surface(x + dx);
        const R step = 2 * to_real<R>(dx), size_of_t = abs(limit.zz);
        if (problem.friction().jumps().empty()) {
          // One ratio r = t_t/t. The limit follows from the slope of the normal displacement.
          const R r = -limit.xz / limit.zz, slope = solution.at(x).slope.left.value / c;
          CHECK(abs(limit.zz + 2 * r * (slope + gamma * r * limit.zz) - limit.xx) < R(1e-40) * size_of_t);
          CHECK(abs(limit.zz + 2 * r * (slope - gamma * r * limit.zz) - limit.xx) > R(0.1) * size_of_t);
        }
        R last = infinity<R>();
        for (const char* depth : {"1/100", "1/10000", "1/100000000"}) {
          CAPTURE(std::string(depth));
          const Rational z = Rational(solved.length) * parse_rational(depth);
          const R zr = to_real<R>(z);
          const StressComponents<R> s = components(solved.interior.at(x, z));
          const R error = difference(s, limit);
          CHECK(error < R(500) * zr * size_of_t);
          if (last < infinity<R>()) CHECK(error < last / 50);
          last = error;
          if (zr > R(1e-6)) continue;
          // d sigma_zz/dz = -d sigma_xz/dx, d sigma_xz/dz = -d sigma_xx/dx.
          const R zz_rate = -(behind.xz - before.xz) / step;
          const R xz_rate = -(behind.xx - before.xx) / step;
          const R slack = R(1e-4) * (abs(zz_rate) + abs(xz_rate));
          CHECK(abs((s.zz - limit.zz) / zr - zz_rate) < slack);
          CHECK(abs((s.xz - limit.xz) / zr - xz_rate) < slack);
          // Controls: the shear with the opposite sign, and sigma_xx without the shear's part.
          if (limit.xz != 0) CHECK(abs(s.xz + limit.xz) > R(0.1) * abs(limit.xz));
          CHECK(abs(s.xx - limit.zz) > R(0.01) * size_of_t);
        }
      }
    }
  }
}

TEST_CASE("beside the contact the surface is free") {
  using std::abs;
  const Solved<R> solved(corners());
  const RiemannHilbertSolution<R>& solution = solved.solution;
  const Solved<double> rough(corners());
  const R c = to_real<R>(solution.problem().problem().elasticity().compliance());
  for (const double fraction : {-0.3, 1.01, 1.5}) {
    CAPTURE(fraction);
    const Rational x = solved.place(fraction);
    const R stretch = 2 * solution.tangential_slope(x).value / c;
    const StressState<R> near = solved.interior.at(x, millionth);
    const StressState<R> nearer = solved.interior.at(x, millionth * millionth);
    CHECK(abs(nearer.xx.value - stretch) < R(1e-8) * abs(stretch));
    // sigma_zz falls like z^2 and sigma_xz like z, not with other powers.
    CHECK(as_double(abs(nearer.zz.value / near.zz.value) * 1e12) == doctest::Approx(1).epsilon(0.01));
    CHECK(as_double(abs(nearer.xz.value / near.xz.value) * 1e6) == doctest::Approx(1).epsilon(0.01));
    CHECK(abs(nearer.zz.value) < R(1e-18) * abs(stretch));
    // These stresses are small, but double has every digit of them. Sums of the size of sigma_xx would lose digits.
    const StressState<double> coarse = rough.interior.at(x, millionth);
    CHECK(coarse.zz.value == doctest::Approx(as_double(near.zz.value)).scale(0).epsilon(1e-12));
    CHECK(coarse.xz.value == doctest::Approx(as_double(near.xz.value)).scale(0).epsilon(1e-12));
    CHECK(abs(near.zz.value) < R(1e-9) * abs(stretch));
  }
}

TEST_CASE("far away there are two forces") {
  using std::abs;
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    const Solved<R> solved(jumps(sliding));
    const Resultants<R> forces = solved.solution.resultants();
    const R along = sliding == Sliding::plus_x ? forces.tangential.value : R(-forces.tangential.value);
    const auto error = [&](int direction, const Rational& distance, const R& normal, const R& tangential) {
      static constexpr int directions[][2] = {{0, 5}, {3, 4}, {-4, 3}};
      const Rational x = distance * directions[direction][0], z = distance * directions[direction][1];
      const StressComponents<R> force = stress_of_force<R>(-normal, tangential, to_real<R>(x), to_real<R>(z));
      return R(difference(components(solved.interior.at(x, z)), force) / size(force));
    };
    for (int direction = 0; direction < 3; ++direction) {
      const R near = error(direction, 1_r / millionth, forces.normal.value, along);
      const R far = error(direction, 1 / (millionth * millionth), forces.normal.value, along);
      CHECK(near < R(1e-5));
      CHECK(as_double(near / far) == doctest::Approx(1e6).epsilon(0.01));
      // Controls: the tangential force contributes nothing straight below the load.
      if (direction > 0) CHECK(error(direction, 1_r / millionth, forces.normal.value, R(-along)) > R(0.01));
      CHECK(error(direction, 1_r / millionth, R(forces.normal.value * R(1.01)), along) > R(0.001));
    }
  }
}

TEST_CASE("out of the plane") {
  const Rational x(2), z(1, 3);
  const auto stress = [&](const Elasticity& elasticity) {
    const ContactProblem p(elasticity, FrictionProfile({0.5_r}), Indenter(1, {{3, Polynomial({0})}}), 2);
    return Solved<double>(p).interior.at(x, z);
  };
  const StressState<double> strain = stress(body());
  CHECK(strain.yy->value == doctest::Approx((strain.xx.value + strain.zz.value) / 5).epsilon(1e-14));
  // The norm of the deviator: von Mises = sqrt(3/2 s:s).
  const double mean = strain.mean()->value, xx = strain.xx.value - mean;
  const double yy = strain.yy->value - mean, zz = strain.zz.value - mean;
  CHECK(xx + yy + zz == doctest::Approx(0).scale(1).epsilon(1e-14));
  const double norm = xx * xx + yy * yy + zz * zz + 2 * strain.xz.value * strain.xz.value;
  CHECK(strain.von_mises()->value == doctest::Approx(std::sqrt(1.5 * norm)).epsilon(1e-14));
  const StressState<double> plane = stress(Elasticity(Solid(0.2_r, 2), Plane::stress));
  CHECK(plane.yy->value == 0);
  CHECK(plane.von_mises()->value > plane.mean()->value);
  const StressState<double> reduced = stress(Elasticity::reduced(0.375_r));
  CHECK(reduced.xx.value == doctest::Approx(strain.xx.value).epsilon(1e-12));
  CHECK_FALSE(reduced.yy);
  CHECK_FALSE(reduced.mean());
  CHECK_FALSE(reduced.von_mises());

  const Solved<double> solved(punch());
  for (const int depth : {0, -1}) CHECK_THROWS_AS(solved.interior.at(x, depth), std::invalid_argument);
}
