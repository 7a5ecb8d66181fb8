// Consistent nodal forces, compared with the load and its moments, known values, polynomials on cells, and Simpson's
// rule.

#include "numeric/solution/nodal_forces.hpp"

#include "model/invalid_data.hpp"
#include "numeric/closed_form/closed_form.hpp"
#include "numeric/interior/interior_stress_problems.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "support/random_problem.hpp"

using namespace steadyslide::numeric::stress_test;

namespace {

template <Real R>
std::vector<NodalForce<R>> forces_of(const ContactSolution<R>& solution, const SurfaceMesh& mesh) {
  return nodal_forces<R>(solution.piecewise_traction(), mesh);
}

/// An uneven mesh, from left to right.
SurfaceMesh random_mesh(const Rational& left, const Rational& right, int order) {
  std::set<Rational> ends{left, right};
  for (int k = uniform(0, 6); k > 0; --k) ends.insert(left + (right - left) * Rational(uniform(1, 999), 1000));
  std::vector<Rational> nodes;
  for (const Rational& x : ends) {
    if (order == 2 && !nodes.empty()) nodes.push_back((nodes.back() + x) / 2);
    nodes.push_back(x);
  }
  return {nodes, order};
}

}  // namespace

TEST_CASE("the forces' sum is the load, their moment the load's; of order 2 the second moment, too") {
  const bool holds = rc::check([] {
    const ContactProblem problem = *rc::gen::oneOf(flat_punch(3), parabola(3));
    const auto solution = closed_form<double>(problem).solution;
    RC_PRE(solution != nullptr);
    const Resultants<double> whole = solution->resultants();
    const auto contact = solution->contact().front();
    const auto whole_number = [](double x) { return Rational(std::floor(x)); };
    const Rational left = whole_number(contact.left.x.value), right = whole_number(contact.right.x.value) + 1;
    const double load = to_real<double>(problem.load());
    const double reach = to_real<double>(right - left) + std::abs(to_real<double>(left));
    double second[2];
    for (const int order : {1, 2}) {
      const SurfaceMesh mesh =
          order == 1 ? random_mesh(left, right, 1) : SurfaceMesh({left, (left + right) / 2, right}, 2);
      const auto forces = forces_of(*solution, mesh);
      double normal = 0, tangential = 0, moment = 0;
      second[order - 1] = 0;
      for (std::size_t i = 0; i < forces.size(); ++i) {
        const double x = to_real<double>(mesh.nodes()[i]);
        normal += forces[i].normal.value;
        tangential += forces[i].tangential.value;
        moment += forces[i].normal.value * x;
        second[order - 1] += forces[i].normal.value * x * x;
      }
      RC_ASSERT(std::abs(normal - load) < 1e-13 * load);
      const double along = problem.sliding() == Sliding::plus_x ? 1 : -1;
      RC_ASSERT(std::abs(tangential - along * whole.tangential.value) < 1e-12 * (load + whole.tangential.value));
      RC_ASSERT(std::abs(moment - whole.centre_of_pressure.value * load) < 1e-12 * load * reach);
    }
    // A quadratic element represents x^2 exactly; a linear one has chords above it.
    RC_ASSERT(second[0] >= second[1] - 1e-12 * load * reach * reach);
  });
  CHECK(holds);
}

TEST_CASE("a frictionless punch: a half, a half; a quarter, a half, a quarter, at 50 digits") {
  using R = Real50;
  const ContactProblem problem(body(), FrictionProfile({0}), Indenter(-1, {{1, Polynomial()}}), 1);
  const auto solution = closed_form<R>(problem).solution;
  for (const NodalForce<R>& force : forces_of(*solution, SurfaceMesh({-1, 1}, 1))) {
    CHECK(size_of(R(force.normal.value - R(1) / 2)) < R("1e-50"));
    CHECK(force.tangential.value == 0);
  }
  const auto forces = forces_of(*solution, SurfaceMesh({-1, 0, 1}, 2));
  CHECK(size_of(R(forces[0].normal.value - R(1) / 4)) < R("1e-50"));
  CHECK(size_of(R(forces[1].normal.value - R(1) / 2)) < R("1e-50"));
  // On [0, 1/2] by x = sin u: int t = 1/6, int t x = (1 - cos(pi/6))/pi.
  const auto parts = forces_of(*solution, SurfaceMesh({-1, 0, 0.5_r, 1}, 1));
  const R moment = (1 - sqrt(R(3)) / 2) / pi<R>();
  const R on_left = (pi<R>() / 2 - 1) / pi<R>();  // the force of the element [-1, 0] on its right node, N = 1 - (-x)
  CHECK(size_of(R(parts[1].normal.value - (on_left + R(1) / 6 - 2 * moment))) < R("1e-50"));
}

TEST_CASE("a short element at a free end: in double as far from 50 digits as the errors say") {
  const ContactProblem problem = jumps();
  const auto rough = riemann_hilbert<double>(problem).solution;
  const auto exact = riemann_hilbert<Real50>(problem).solution;
  const Rational left(rough->contact().front().left.x.value), right(rough->contact().back().right.x.value);
  for (const char* length : {"1/1000", "1/10000000", "1/1000000000"}) {
    const Rational h = parse_rational(length);
    const SurfaceMesh mesh({left - h, left + h, 0, right - h, right + h}, 1);
    const auto found = forces_of(*rough, mesh);
    const auto expected = forces_of(*exact, mesh);
    for (std::size_t i = 0; i < found.size(); ++i) {
      CAPTURE(i);
      CAPTURE(std::string(length));
      CHECK(within_error(found[i].normal, expected[i].normal));
      CHECK(within_error(found[i].tangential, expected[i].tangential));
    }
  }
}

TEST_CASE("cells: a constant times a polynomial, by Simpson's rule on what cells and elements share") {
  const auto solution = variational_inequality(jumps(), {.cells = 512}).solution;
  const PiecewiseTraction<double> traction = solution->piecewise_traction();
  const SurfaceMesh mesh({-1, -0.3_r, 0.4_r, 0.6_r, 0.8_r}, 2);
  const auto forces = nodal_forces<double>(traction, mesh);
  std::vector<double> normal(5), tangential(5);
  for (std::size_t e = 0; e < 2; ++e) {
    const double a = to_real<double>(mesh.nodes()[2 * e]), b = to_real<double>(mesh.nodes()[2 * e + 2]);
    for (const TractionPanel<double>& panel : traction.panels()) {
      const double from = std::max(a, panel.left.high), to = std::min(b, panel.right.high);
      if (from >= to) continue;
      const double t = traction.constant(panel);
      for (const auto& [x, weight] : {std::pair(from, 1.0), {(from + to) / 2, 4.0}, {to, 1.0}}) {
        const double xi = 2 * (x - a) / (b - a) - 1;
        const double shapes[] = {xi * (xi - 1) / 2, 1 - xi * xi, xi * (xi + 1) / 2};
        for (std::size_t i = 0; i < 3; ++i) {
          normal[2 * e + i] -= t * shapes[i] * weight * (to - from) / 6;
          tangential[2 * e + i] += panel.shear_ratio * t * shapes[i] * weight * (to - from) / 6;
        }
      }
    }
  }
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(std::abs(forces[i].normal.value - normal[i]) < 1e-13);
    CHECK(std::abs(forces[i].tangential.value - tangential[i]) < 1e-13);
  }
  // The forces of the other methods, to the accuracy of the cells.
  const auto sharp = forces_of(*riemann_hilbert<double>(jumps()).solution, mesh);
  for (std::size_t i = 0; i < 5; ++i) CHECK(std::abs(sharp[i].normal.value - normal[i]) < 0.01);
}

TEST_CASE("wedges and many nodes: sums stay the load, in double and at 50 digits") {
  const ContactProblem problem = corners();
  std::vector<Rational> nodes;
  for (int k = -400; k <= 400; ++k) nodes.push_back(Rational(k, 200));
  const SurfaceMesh mesh(nodes, 2);
  const auto solution = riemann_hilbert<double>(problem).solution;
  double sum = 0, tangential = 0;
  for (const NodalForce<double>& force : forces_of(*solution, mesh)) {
    sum += force.normal.value;
    tangential += force.tangential.value;
  }
  CHECK(std::abs(sum - 1) < 1e-13);
  CHECK(std::abs(tangential - solution->resultants().tangential.value) < 1e-12);
  const auto exact = riemann_hilbert<Real50>(problem).solution;
  Real50 load = 0;
  for (const NodalForce<Real50>& force : forces_of(*exact, SurfaceMesh({-2, 0.1_r, 2}, 1))) load += force.normal.value;
  CHECK(size_of(Real50(load - 1)) < Real50("1e-48"));
}

TEST_CASE("contact outside the mesh is refused, with the node beyond which it lies") {
  const ContactProblem problem(body(), FrictionProfile({0}), Indenter(-1, {{1, Polynomial()}}), 1);
  const auto solution = closed_form<double>(problem).solution;
  const auto field = [&](const SurfaceMesh& mesh) -> std::string {
    try {
      forces_of(*solution, mesh);
    } catch (const InvalidData& invalid) {
      return invalid.field() + ": " + invalid.what();
    }
    return "";
  };
  CHECK(field(SurfaceMesh({-1, 1}, 1)) == "");
  CHECK(field(SurfaceMesh({-0.999_r, 0, 1}, 1)) ==
        "nodes[0]: contact outside the mesh; the mesh covers the contact; -1");
  CHECK(field(SurfaceMesh({-1, 0, 0.999_r}, 1)) ==
        "nodes[2]: contact outside the mesh; the mesh covers the contact; 1");
}
