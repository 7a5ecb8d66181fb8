#include "numeric/cauchy/residuals.hpp"
#include "proofs_checks/instruments/operators/inverse_operator.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::eq_10_inverse {
namespace {

/// A linear u' under constant friction.
struct LinearSlope {
  ContactProblem problem;
  Polynomial slope;

  Rational s() const { return s_of(problem, 0); }
};

std::string text_of(const LinearSlope& c) { return proofs_checks::text_of(c.problem) + ", u' = " + to_string(c.slope); }

CaseList<LinearSlope> slopes(const Context& context) {
  CaseList<LinearSlope> list{{{punch(Rational(3, 10), {2}), Polynomial({1, Rational(1, 2)})},
                              {punch(Rational(-9, 10), {1}), Polynomial({0, 1})},
                              {punch(Rational(499, 1000), {10}), Polynomial({1})},
                              {punch(0, {0}), Polynomial({1, -2})}},
                             {}};
  const auto random = grid_and_random<LinearSlope>(context, "eq-10", {}, {30, 10, 4}, [&](Random& random) {
    const Rational nu = random.poisson();
    const Rational f = random.friction(largest_friction(context));
    const Rational constant = random.between(-1, 1);
    return LinearSlope{punch(nu, {f}), Polynomial({constant, random.between(0, 3)})};
  });
  list.cases.insert(list.cases.end(), random.cases.begin(), random.cases.end());
  list.detail =
      "4 of a grid, " + std::to_string(random.cases.size()) + " random with seed " + std::to_string(context.seed);
  return list;
}

template <Real R>
void check_inverse(Findings& findings, const InverseFormula& formula, const LinearSlope& c) {
  using std::abs;
  // The traction of load 0 with A t = u': if u'/Y = Q + O(1/z), then t = cos(pi alpha) |Y| Q.
  const PanelDensity<R> closed = density_of(inverse_without_integral<R>(c.s(), c.slope));
  const std::vector<R> u = coefficients_of<R>(c.slope);
  const numeric::SurfaceCheck<R> surface({closed}, {to_real<R>(c.problem.coupled_friction(0))},
                                         [&u](std::size_t, const Node<R>& node) { return value_of(u, node.x); });
  R size = 0;
  for (const R& coefficient : u) size += abs(coefficient);
  findings.compare("equation", static_cast<double>(surface.equation()));
  findings.compare("load", R(abs(surface.integral()) / size));

  const InverseOperator<R> inverse(formula, c.slope);
  for (const int percent : {40, 3, 75}) {
    const auto at = inverse.point(0, R(percent) / 100);
    const R expected = closed(at.node);
    findings.compare("trapezoidal", inverse.terms(at).difference(expected));
    if (percent == 40) findings.compare("tanh sinh", inverse.terms_by_tanh_sinh(at).difference(expected));
  }
}

}  // namespace

Claim claim() {
  return formula_claim<LinearSlope, InverseFormula>("eq-10-inverse")
      .cases(slopes)
      .effective_where([](const LinearSlope& c) { return c.s() != 0; })
      .says([](const LinearSlope& c) { return InverseFormula::of(c.s()); })
      .checked([]<Real R>(auto&... of) { check_inverse<R>(of...); })
      .wrong("the printed `(1+x)^{1/2}` instead of `(1+x)^{1/2+alpha}`, in both places", &InverseFormula::rear, -half)
      .wrong("`alpha` of the other sign in the weight", [](InverseFormula& l) { std::swap(l.rear, l.front); })
      .wrong("the sign of the local term", [](InverseFormula& l) { l.local *= -1; })
      .wrong("`1/(1+s^2)` missing before the integral", &InverseFormula::integral, 1)
      .near_miss("the local term", &InverseFormula::local)
      .near_miss("the integral", &InverseFormula::integral);
}

}  // namespace steadyslide::proofs_checks::eq_10_inverse
