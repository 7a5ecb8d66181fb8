// The displacement of the body by independent methods: the displacement of the surface as the solver has it,
// differences that are the gradient of the stresses, and 50 digits. Also the stress at the surface, as a limit.

#include "numeric/interior/interior_displacement.hpp"

#include "numeric/interior/interior_stress_problems.hpp"
#include "numeric/interior/surface_stress.hpp"

using namespace steadyslide::numeric::stress_test;

namespace {

template <Real R>
InteriorDisplacement<R> displacement_of(const Solved<R>& solved, const ContactProblem& problem) {
  return {solved.interior.traction(), problem.origin_of_displacement()};
}

const std::vector<ContactProblem> problems{jumps(), corners(), corners(Sliding::minus_x), punch(), parabola()};

}  // namespace

TEST_CASE("at the surface u_z is -u, in the contact, at its ends and beyond") {
  for (const ContactProblem& problem : problems) {
    const Solved<double> solved(problem);
    const InteriorDisplacement<double> displacement = displacement_of(solved, problem);
    for (const double fraction : {-0.7, 0.0, 1e-6, 0.3, 0.75, 1.0, 1.4}) {
      CAPTURE(fraction);
      const Rational x = solved.place(fraction);
      const Estimate<double> found = displacement.at(x, 0).z;
      const Estimate<double> expected = -solved.solution.details_at(x).displacement;
      CHECK(std::abs(found.value - expected.value) <= found.error + expected.error);
      CHECK(found.error < 1e-9);
    }
  }
}

TEST_CASE("differences are the gradient of the stresses") {
  const Rational step = parse_rational("1e-5");
  for (const ContactProblem& problem : problems) {
    const Solved<double> solved(problem);
    const InteriorDisplacement<double> displacement = displacement_of(solved, problem);
    for (const double fraction : {-0.4, 1e-3, 0.6, 1.2}) {
      for (const char* depth : {"2", "1/10", "1/100"}) {
        CAPTURE(fraction);
        CAPTURE(std::string(depth));
        const Rational x = solved.place(fraction), z = parse_rational(depth);
        const StressState<double> state = solved.interior.at(x, z);
        const auto slope = [&](Estimate<double> Displacement<double>::*part, const Rational& dx, const Rational& dz) {
          const double rise =
              (displacement.at(x + dx, z + dz).*part).value - (displacement.at(x - dx, z - dz).*part).value;
          return rise / to_real<double>(2 * (dx + dz));
        };
        const double scale = std::abs(state.gradient->x_x.value) + std::abs(state.gradient->z_x.value);
        const auto same = [&](double one, double other) { return std::abs(one - other) < 1e-4 * scale; };
        CHECK(same(slope(&Displacement<double>::x, step, 0), state.gradient->x_x.value));
        CHECK(same(slope(&Displacement<double>::x, 0, step), state.gradient->x_z.value));
        CHECK(same(slope(&Displacement<double>::z, step, 0), state.gradient->z_x.value));
        CHECK(same(slope(&Displacement<double>::z, 0, step), state.gradient->z_z.value));
        // Control: the rotation of the other sense.
        CHECK_FALSE(same(slope(&Displacement<double>::x, 0, step), state.gradient->z_x.value));
      }
    }
  }
}

TEST_CASE("the errors of double cover the differences from 50 digits") {
  const ContactProblem problem = corners(Sliding::minus_x);
  const Solved<Real50> solved(problem);
  const Solved<double> rough(problem);
  const InteriorDisplacement<Real50> exact = displacement_of(solved, problem);
  const InteriorDisplacement<double> displacement = displacement_of(rough, problem);
  for (const double fraction : {-0.4, 1e-3, 0.6}) {
    for (const char* depth : {"2", "1/1000"}) {
      const Rational x = solved.place(fraction), z = parse_rational(depth);
      const Displacement<Real50> truth = exact.at(x, z);
      const Displacement<double> found = displacement.at(x, z);
      CHECK(within_error(found.x, truth.x));
      CHECK(within_error(found.z, truth.z));
      CHECK(std::max(found.x.error, found.z.error) < 1e-9);
    }
  }
}

TEST_CASE("at the surface the stress is the limit of those below") {
  using R = Real50;
  for (const ContactProblem& problem : {jumps(), corners(Sliding::minus_x)}) {
    const Solved<R> solved(problem);
    for (const double fraction : {-0.4, 1e-3, 0.6, 1.2}) {
      CAPTURE(fraction);
      const Rational x = solved.place(fraction);
      const StressState<R> found = surface_stress(problem.elasticity(), solved.solution.details_at(x));
      const std::vector<Estimate<R>> limit = numbers(solved.interior.at(x, parse_rational("1e-25")));
      const std::vector<Estimate<R>> values = numbers(found);
      R scale = 0;
      for (const Estimate<R>& one : limit) scale += size_of(one.value);
      for (std::size_t k = 0; k < values.size(); ++k) {
        CAPTURE(k);
        CHECK(size_of(R(values[k].value - limit[k].value)) < R(1e-15) * scale);
      }
    }
  }
}
