#include "numeric/cauchy/sliding_operator.hpp"
#include "proofs_checks/instruments/operators/complex_jet.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::plemelj {
namespace {

using numeric::BoundaryLimit;

/// A traction with Y by its powers, G on each panel, and the factor of Y/i in Phi.
struct PlemeljJump : PowerProduct {
  std::vector<Complex<Number>> ratios;
  Number potential;
};

CaseList<ContactProblem> punches(const Context& context) {
  const std::vector<ContactProblem> grid{
      punch(Rational(3, 10), {Rational(1, 2), 2, 1}, {Rational(-1, 3), Rational(2, 5)}, 3),
      punch(Rational(3, 10), {Rational(3, 5)}),
      punch(Rational(-9, 10), {50, 0, 10}, {0, Rational(1, 2)}, 1, Sliding::minus_x),
      punch(Rational(499, 1000), {0, 50}, {Rational(-3, 4)})};
  return grid_and_random(context, "plemelj", grid, {60, 60, 60},
                         [&](Random& random) { return random_punch(context, random, random.below(6)); });
}

PlemeljJump jump_of(const ContactProblem& p) {
  PlemeljJump jump{punch_traction(p), {}, to_real<Number>(p.load()) / (2 * numeric::pi<Number>())};
  for (std::size_t k = 0; k < p.friction().values().size(); ++k) {
    // (s-i)/(s+i) = (s-i)^2/(1+s^2)
    const Rational s = s_of(p, k);
    const Rational scale = 1 + s * s;
    jump.ratios.push_back({to_real<Number>((s * s - 1) / scale), to_real<Number>(-2 * s / scale)});
  }
  return jump;
}

template <class R>
double distance(const Complex<R>& a, const Complex<R>& b, const R& size) {
  using std::sqrt;
  const Complex<R> c = a - b;
  return static_cast<double>(R(sqrt(R(c.re * c.re + c.im * c.im)) / size));
}

/// Checks Plemelj's formulas by quadrature: H t = i (Phi^+ + Phi^-), and H t + s t, the operator's value, is zero.
template <Real R>
void check_operator(Findings& findings, const PowerForm<R>& form, const R& potential, const ContactProblem& problem) {
  using std::abs;
  const Surface<R> surface = surface_of<R>(form, problem, 0);
  const numeric::FundamentalSolution<R> y = form.traction().weight;
  const trapezoidal::Grid<R> grid(surface.traction);
  const numeric::SlidingOperator<R> A(grid, surface.s);
  for (std::size_t k = 0; k < y.panel_count(); ++k) {
    for (const int tenths : {3, 8}) {
      const PanelPoint<R> at = grid.midpoint_near(k, R(tenths) / 10);
      const numeric::SlidingTerms<R> terms = A.at(at);
      const R size = 2 * potential * y.modulus(k, at.node);
      // i Phi = potential Y.
      const R banks = potential * (y.boundary(k, at.node, BoundaryLimit::plus).re +
                                   y.boundary(k, at.node, BoundaryLimit::minus).re);
      findings.compare("sum", R(abs(terms.hilbert.value - banks) / size));
      findings.compare("operator", R(abs(terms.sum().value) / size));
    }
  }
}

template <Real R>
void check_jump(Findings& findings, const PlemeljJump& formula, const ContactProblem& problem) {
  using std::abs, std::cos, std::sin;
  const PowerForm<R> form = formula.at<R>();
  const R potential(formula.potential);
  const numeric::PowerTraction<R> t = form.traction();
  const auto& y = t.weight;
  const R small = R(tolerance<R>()) / 1000;
  const R shortest = std::ranges::min(form.lengths);

  for (std::size_t k = 0; k < y.panel_count(); ++k) {
    const numeric::Panel<R>& panel = y.panel(k);
    const Complex<R> ratio{R(formula.ratios[k].re), R(formula.ratios[k].im)};
    const R turn = 2 * numeric::pi<R>() * to_real<R>(alpha(problem, k));
    findings.compare("angle", distance<R>(ratio, {-cos(turn), -sin(turn)}, R(1)));
    for (const int tenths : {3, 5, 8}) {
      const Node<R> node = panel.node_from_left(panel.length * tenths / 10);
      const Complex<R> above = y.boundary(k, node, BoundaryLimit::plus);
      const Complex<R> below = y.boundary(k, node, BoundaryLimit::minus);
      const R size = y.modulus(k, node);
      findings.compare("jump", distance(above, ratio * below, size));
      // Phi = potential Y/i, and (a + bi)/i = b - ai.
      const Complex<R> difference{potential * (above.im - below.im), potential * (below.re - above.re)};
      const R value = t(k, node);
      findings.compare("traction", distance<R>(difference, {value, R(0)}, abs(value)));
      // Off the axis distances are differences of coordinates, so a short panel loses digits.
      const R height = small * shortest;
      findings.compare("limit", static_cast<double>(shortest) * distance(y.at({node.x, height}), above, size));
      findings.compare("limit", static_cast<double>(shortest) * distance(y.at({node.x, R(-height)}), below, size));
    }
  }
  check_operator(findings, form, potential, problem);
  const Complex<R> far{R(0), R(1 / small)};
  const R load = to_real<R>(problem.load()) / (2 * numeric::pi<R>());
  findings.compare("infinity", distance<R>(potential * (far * y.at(far)), {load, R(0)}, load));
}

}  // namespace

Claim claim() {
  return formula_claim<ContactProblem, PlemeljJump>("plemelj")
      .cases(punches)
      .effective_where(has_friction)
      .says(jump_of)
      .checked([]<Real R>(auto&... of) { check_jump<R>(of...); })
      .wrong("`G = (s+i)/(s-i)`",
             [](PlemeljJump& jump) { std::ranges::for_each(jump.ratios, [](auto& g) { g.im *= -1; }); })
      .wrong("`G = -(s-i)/(s+i)`",
             [](PlemeljJump& jump) { std::ranges::for_each(jump.ratios, [](auto& g) { g = Number(-1) * g; }); })
      .wrong("the powers of both edges exchanged",
             [](PlemeljJump& jump) { std::swap(jump.exponents.front(), jump.exponents.back()); })
      .wrong("the exponent of one jump missing", [](PlemeljJump& jump) { jump.exponents[1] = Exponent(0); })
      .wrong("`Phi = P Y/(pi i)`", [](PlemeljJump& jump) { jump.potential *= 2; })
      .wrong("`cos(pi alpha)` missing in `t`",
             [](PlemeljJump& jump) { std::ranges::fill(jump.amplitudes, Number(-2 * jump.potential)); })
      .near_miss("one jump's exponent", [](PlemeljJump& jump, const Number& step) { jump.move_power(1, step); })
      .near_miss("`Phi`", &PlemeljJump::potential);
}

}  // namespace steadyslide::proofs_checks::plemelj
