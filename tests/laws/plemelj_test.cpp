// Y+ = G Y- on every panel, and the boundary values are the limits of Y off the axis.

#include "numeric/closed_form/closed_form.hpp"
#include "support/numeric_test.hpp"
#include "support/random_problem.hpp"

namespace {

Complex<Real50> times(const Complex<Real50>& a, const Complex<Real50>& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

Real50 distance(const Complex<Real50>& a, const Complex<Real50>& b) {
  return sqrt((a.re - b.re) * (a.re - b.re) + (a.im - b.im) * (a.im - b.im));
}

/// G = (s - i)/(s + i).
Complex<Real50> coefficient(const Rational& s) {
  const Rational size = 1 + s * s;
  return {to_real<Real50>((s * s - 1) / size), to_real<Real50>(-2 * s / size)};
}

}  // namespace

TEST_CASE("Plemelj") {
  CHECK(rc::check("flat punches and parabolas", [] {
    const ContactProblem p = *rc::gen::oneOf(flat_punch(4), parabola(4));
    const auto data = std::get<ClosedFormData<Real50>>(closed_form_data<Real50>(p));
    const FundamentalSolution<Real50>& y = data.traction.weight;
    for (std::size_t k = 0; k < y.panel_count(); ++k) {
      const Node<Real50> node = y.panel(k).node_from_left(Real50(y.panel(k).length * 3 / 8));
      const Complex<Real50> above = y.boundary(k, node, BoundaryLimit::plus);
      const Complex<Real50> below = y.boundary(k, node, BoundaryLimit::minus);
      const Rational s = p.coupled_friction(data.first_piece + k);
      const Real50 size = y.modulus(k, node);
      RC_ASSERT(distance(above, times(coefficient(s), below)) <= 1e-48 * size);
      // Control: friction of the opposite sign is refuted, unless friction is 0.
      if (s != 0) RC_ASSERT(distance(above, times(coefficient(-s), below)) > 1e-6 * size);
      const Real50 height = y.panel(k).length * Real50("1e-25");
      RC_ASSERT(distance(above, y.at({node.x, height})) <= 1e-20 * size);
      RC_ASSERT(distance(below, y.at({node.x, Real50(-height)})) <= 1e-20 * size);
    }
  }));
}
