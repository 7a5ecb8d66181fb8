#include "numeric/cauchy/residuals.hpp"
#include "proofs_checks/instruments/operators/inverse_operator.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/formula_claim.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// u' = constant + linear x under constant friction.
struct LinearSlope {
  ContactProblem problem;
  Rational constant;
  Rational linear;

  Polynomial slope() const { return Polynomial({constant, linear}); }
  Rational s() const { return problem.coupled_friction(0); }
};

std::string text_of(const LinearSlope& c) {
  return proofs_checks::text_of(c.problem) + ", u' = " + to_string(c.slope());
}

CaseList<LinearSlope> slopes(const Context& context) {
  CaseList<LinearSlope> list{{{punch(Rational(3, 10), {2}), 1, Rational(1, 2)},
                              {punch(Rational(-9, 10), {1}), 0, 1},
                              {punch(Rational(499, 1000), {10}), 1, 0},
                              {punch(0, {0}), 1, -2}},
                             {}};
  Random random(context.seed, "eq-10");
  const std::size_t count = context.quick ? 1 : count_for(context, {30, 10, 4});
  for (std::size_t k = 0; k < count; ++k) {
    const Rational nu = random.poisson();
    const Rational f = random.friction(largest_friction(context));
    const Rational constant = random.between(-1, 1);
    list.cases.push_back({punch(nu, {f}), constant, random.between(0, 3)});
  }
  list.detail = "4 of a grid, " + std::to_string(count) + " random with seed " + std::to_string(context.seed);
  return list;
}

/// The traction of load 0 with A t = u', in closed form: with u'/Y = Q + O(1/z), t = cos(pi alpha) |Y| Q.
template <Real R>
numeric::PiecewiseDensity<R> closed_inverse(const LinearSlope& c) {
  const R a = numeric::to_real<R>(alpha(c.problem, 0));
  const R constant = numeric::to_real<R>(c.constant);
  const R linear = numeric::to_real<R>(c.linear);
  const R cosine = numeric::cos_pi_alpha<R>(c.s());
  numeric::PanelDensity<R> panel{
      {R(-1), R(1), R(2)},
      numeric::Power<R>::of(-(half + alpha(c.problem, 0))),
      numeric::Power<R>::of(-(half - alpha(c.problem, 0))),
      [=](const numeric::Node<R>& node) {
        const R& x = node.x;
        return R(cosine * (constant * (x + 2 * a) + linear * (x * x + 2 * a * x + (4 * a * a - 1) / 2)));
      }};
  return {std::move(panel)};
}

template <Real R>
void check_inverse(Findings& findings, const InverseFormula& formula, const LinearSlope& c) {
  using std::abs;
  const R constant = numeric::to_real<R>(c.constant);
  const R linear = numeric::to_real<R>(c.linear);
  const numeric::PiecewiseDensity<R> closed = closed_inverse<R>(c);
  const numeric::SurfaceCheck<R> surface(
      closed, {numeric::to_real<R>(c.s())},
      [=](std::size_t, const numeric::Node<R>& node) { return R(constant + linear * node.x); });
  findings.compare("equation", static_cast<double>(surface.equation()));
  findings.compare("load", static_cast<double>(R(abs(surface.integral()) / (abs(constant) + abs(linear)))));

  const InverseOperator<R> inverse(formula, c.slope());
  for (const int percent : {40, 3, 75}) {
    const auto at = inverse.point(0, R(percent) / 100);
    const R expected = closed[0](at.node);
    findings.compare("trapezoidal", inverse.terms(at).difference(expected));
    if (percent == 40) findings.compare("tanh sinh", inverse.terms_by_tanh_sinh(at).difference(expected));
  }
}

}  // namespace

Claim eq_10_inverse() {
  return formula_claim<LinearSlope, InverseFormula>("eq-10-inverse")
      .cases(slopes)
      .effective_where([](const LinearSlope& c) { return c.s() != 0; })
      .quantities({"equation", "load", "trapezoidal", "tanh sinh"})
      .says([](const LinearSlope& c) { return InverseFormula::of(c.s()); })
      .checked([]<numeric::Real R>(auto&... of) { check_inverse<R>(of...); })
      .wrong("the printed (1+x)^{1/2} instead of (1+x)^{1/2+alpha}, in both places",
             [](InverseFormula& l) { l.rear = -half; })
      .wrong("alpha of the other sign in the weight", [](InverseFormula& l) { std::swap(l.rear, l.front); })
      .wrong("the sign of the local term", [](InverseFormula& l) { l.local *= -1; })
      .wrong("1/(1+s^2) missing before the integral", [](InverseFormula& l) { l.integral = 1; })
      .near_miss("the local term", &InverseFormula::local)
      .near_miss("the integral", &InverseFormula::integral);
}

}  // namespace steadyslide::proofs_checks
