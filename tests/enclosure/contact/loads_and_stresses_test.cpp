// Nodal loads on a mesh and stresses below the surface as balls, compared with the numeric layer and with laws of
// equilibrium.

#include "enclosure/contact/interior_stress.hpp"
#include "enclosure/contact/nodal_forces.hpp"
#include "model/invalid_data.hpp"
#include "numeric/interior/interior_stress.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "numeric/solution/nodal_forces.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"

namespace {

using namespace steadyslide::enclosure;

struct Solved {
  ContactProblem problem;
  std::shared_ptr<const ContactSolution<Real50>> solution;
  EnclosedSolution enclosed;
};

Solved solved(const ContactProblem& problem) {
  const auto solution = riemann_hilbert<Real50>(problem).solution;
  const ContactProof proof = prove_contact(problem, solution->approximate_contact(), 50);
  REQUIRE_MESSAGE(proof.proved, proof.reason);
  return {problem, solution, EnclosedSolution(problem, proof)};
}

/// A punch over two jumps; a wedge on a jump, in full contact; a wedge beside a jump; a parabola over a jump.
std::vector<ContactProblem> problems() {
  const auto wedge = [](const Rational& corner) {
    return Indenter(-1, {{corner, Polynomial({0, -0.1_r})}, {1, Polynomial({-0.2_r * corner, 0.1_r})}});
  };
  return {reduced({0.1_r, 0.5_r, 0.2_r}, {-0.3_r, 0.4_r}, one_piece(-1, 1, {}), 1),
          reduced({0.6_r, 0.2_r}, {0}, wedge(0), 3), reduced({0.1_r, 0.3_r}, {0.5_r}, wedge(-0.2_r), 3),
          reduced({0.1_r, 0.6_r}, {0}, one_piece(-1, 1, {0, 0, 2.5_r}), 1)};
}

/// Checks agreement with 50 digits to 1e-38.
void agrees(const Ball& ball, const Real50& value) {
  REQUIRE(ball.is_finite());
  Ball said(0, 400);
  arb_set_str(said.get(), value.str(48).c_str(), 400);
  const Ball distance = abs(ball - said).upper();
  CHECK_MESSAGE(distance < (Ball(1) + abs(ball)) * power(Ball(10, 64), -36), distance);
  CHECK(ball.radius() < (Ball(1) + abs(ball)) * power(Ball(10, 64), -40));
}

}  // namespace

TEST_CASE("stresses below the surface are the numeric layer's, near it and far from it") {
  for (const ContactProblem& problem : problems()) {
    const Solved state = solved(problem);
    const auto* form = dynamic_cast<const RiemannHilbertSolution<Real50>*>(state.solution.get());
    REQUIRE(form);
    const InteriorStress<Real50> numeric(*form);
    for (const auto& at : {std::pair(0.1_r, 0.5_r), {-0.2_r, 1e-6_r}, {0.5_r, 0.01_r}, {-3, 2}, {0, 1e-3_r}}) {
      const Rational &x = at.first, &z = at.second;
      INFO("x = ", to_string(x), ", z = ", to_string(z));
      const StressComponents stress = interior_stress(state.enclosed, x, z);
      const StressState<Real50> expected = numeric.at(x, z);
      agrees(stress.xx, expected.xx.value);
      agrees(stress.zz, expected.zz.value);
      agrees(stress.xz, expected.xz.value);
    }
  }
  const Solved state = solved(problems()[0]);
  CHECK_THROWS_AS(interior_stress(state.enclosed, 0, 0), InvalidData);
}

TEST_CASE("nodal forces: their sum is the load, their moment the load's, on any mesh of either order") {
  for (const ContactProblem& problem : problems()) {
    const Solved state = solved(problem);
    const auto resultants = state.enclosed.resultants();
    for (const int order : {1, 2}) {
      // An uneven mesh, with nodes at places of the data.
      const std::vector<Rational> nodes =
          order == 1 ? std::vector<Rational>{-1.5_r, -1, -0.75_r, -0.3_r, 0, 0.1_r, 0.4_r, 1, 2}
                     : std::vector<Rational>{-1, -0.65_r, -0.3_r, -0.15_r, 0, 0.2_r, 0.4_r, 0.7_r, 1};
      Ball normal(0, 200), tangential(0, 200), moment(0, 200), linear(0, 200);
      const std::vector<enclosure::NodalForce> forces = nodal_forces(state.enclosed, nodes, order);
      const auto expected =
          numeric::nodal_forces<Real50>(state.solution->piecewise_traction(), SurfaceMesh(nodes, order));
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        agrees(forces[i].normal, expected[i].normal.value);
        agrees(forces[i].tangential, expected[i].tangential.value);
        normal += forces[i].normal;
        tangential += forces[i].tangential;
        moment += forces[i].normal * Ball(nodes[i], 200);
      }
      CHECK(normal.contains(problem.load()));
      CHECK(normal.radius() < power(Ball(10, 64), -40));
      CHECK(moment.overlaps(resultants.centre_of_pressure * Ball(problem.load(), 200)));
      CHECK(tangential.overlaps(resultants.tangential));  // towards +x, the direction of sliding
    }
  }
}

TEST_CASE("nodal forces under a frictionless flat punch are known") {
  // t = -1/(pi sqrt(1-x^2)): one linear element takes half the load at each end; a quadratic one has the second moment:
  // 1/4, 1/2 and 1/4.
  const Solved state = solved(reduced({0}, {}, one_piece(-1, 1, {}), 1));
  for (const enclosure::NodalForce& force : nodal_forces(state.enclosed, {-1, 1}, 1))
    CHECK(force.normal.contains(0.5_r));
  const std::vector<enclosure::NodalForce> forces = nodal_forces(state.enclosed, {-1, 0, 1}, 2);
  CHECK(forces[0].normal.contains(0.25_r));
  CHECK(forces[1].normal.contains(0.5_r));
  CHECK(forces[1].normal.radius() < power(Ball(10, 64), -45));
}

TEST_CASE("meshes that are none are refused") {
  const Solved state = solved(reduced({0}, {}, one_piece(-1, 1, {}), 1));
  const auto refused = [&](const std::vector<Rational>& nodes, int order) {
    CHECK_THROWS_AS(nodal_forces(state.enclosed, nodes, order), InvalidData);
  };
  refused({-1, 0, 0, 1}, 1);
  refused({-1, 0, 0.5_r}, 1);      // contact reaches beyond the mesh
  refused({-1, 0.1_r, 1}, 2);      // the node is not in the middle
  refused({-1, -0.5_r, 0, 1}, 2);  // one midside node is missing
  refused({-1, 1}, 3);
  refused({-1}, 1);
}
