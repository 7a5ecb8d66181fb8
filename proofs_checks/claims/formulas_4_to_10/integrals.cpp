// A published integral that default quadrature gets wrong, and the inverse of the operator under constant friction.
// [Bal16, (10)]

#include <algorithm>

#include "numeric/cauchy/residuals.hpp"
#include "numeric/quadrature/gsl_quadrature.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

struct Nothing {};

/// int weight(x)/(x-2) dx over ]-1, 1[ and its value.
template <class R>
struct IntegralForm : PowerForm<R> {
  R value;
};
using IntegralFormula = Formula<IntegralForm, Nothing>;

IntegralFormula published_formula() {
  return IntegralFormula::from([]<Real R>(const Nothing&) {
    using std::pow, std::sqrt;
    const R value = -numeric::pi<R>() * sqrt(R(2)) / pow(R(3), R(3) / 4);
    return IntegralForm<R>{power_form<R>({-1, 1}, {Exponent(Rational(-3, 4)), Exponent(Rational(-1, 4))}, {R(1)}),
                           value};
  });
}

template <Real R>
std::vector<Evidence> check_published_at(const IntegralFormula& formula) {
  const IntegralForm<R> form = formula.at<R>({});
  const numeric::PiecewiseDensity<R> density = form.traction().density();
  Findings findings;
  findings.begin_case("gamma f = 1, x = 2");
  findings.decide(
      "arctan(1)/pi = 1/4: the powers at the edges are -3/4 and -1/4",
      Exponent::angle(1) == Exponent(Rational(1, 4)) &&
          form.exponents == std::vector<Exponent>{-(half + Exponent::angle(1)), -(half - Exponent::angle(1))});
  const R pi = numeric::pi<R>();
  findings.compare(
      {"value of the integral, trapezoidal rule", {"trapezoidal rule", "-pi sqrt(2)/3^{3/4}"}, tolerance<R>()},
      relative_difference<R>(pi * numeric::trapezoidal::Grid<R>(density).cauchy(Side::right, R(1)), form.value));
  findings.compare(
      {"value of the integral, tanh-sinh rule",
       {"tanh-sinh rule with absorbed powers", "-pi sqrt(2)/3^{3/4}"},
       tolerance<R>()},
      relative_difference<R>(pi * numeric::tanh_sinh::cauchy<R>(density, Side::right, R(1)).value, form.value));

  const IntegralForm<double> in_double = formula.at<double>({});
  numeric::PiecewiseDensity<double> with_kernel = in_double.traction().density();
  with_kernel[0].smooth = [](const numeric::Node<double>& node) { return 1 / (node.x - 2); };
  const auto by_gsl = numeric::gsl::integral(with_kernel);
  const Quantity gsl{"value of the integral, GSL in double", {"GSL's QAWS", "-pi sqrt(2)/3^{3/4}"}, 1e-12};
  if (by_gsl.convergence == numeric::Convergence::reached) {
    findings.compare(gsl, relative_difference<double>(by_gsl.value, in_double.value));
  } else {
    findings.skip(gsl);
  }
  return findings.evidence("the one published case");
}

Claim published_integral() {
  const IntegralFormula right = published_formula();
  const auto check = [](const Context& context, const IntegralFormula& formula) {
    return gather([&] {
      return numeric::at_precision(context.digits, [&]<Real R>() { return check_published_at<R>(formula); });
    });
  };
  return make_claim(
      claim_text("published-galin-at-2"), check, right,
      std::vector<Wrong<IntegralFormula>>{
          {"the edges exchanged: ((1-x)^3 (1+x))^{1/4}",
           right.changed([](auto& form, const Nothing&) { std::swap(form.powers[0], form.powers[1]); })},
          {"the value with the other sign",
           right.changed([](auto& form, const Nothing&) { form.value = -form.value; })},
          {"3^{1/4} for 3^{3/4}", right.changed([]<Real R>(IntegralForm<R>& form, const Nothing&) {
             using std::sqrt;
             form.value *= sqrt(R(3));
           })},
          {"wrong in the fifth digit, as a default quadrature has it",
           right.changed([](auto& form, const Nothing&) { form.value += form.value / 100'000; })},
          {"near miss: the value moved by ten times the tolerance",
           right.changed([]<Real R>(IntegralForm<R>& form, const Nothing&) { form.value *= 1 + near_miss<R>(); })},
          {"near miss: the rear power moved by ten times the tolerance",
           right.changed([]<Real R>(IntegralForm<R>& form, const Nothing&) { form.move_power(0, near_miss<R>()); })}});
}

/// u' = constant + linear x under constant friction.
struct SlopeCase {
  ContactProblem problem;
  Rational constant;
  Rational linear;
};

/// L(u) = local u' - nonlocal W(x) (1/pi) PV int u'(x')/(W(x') (x'-x)) dx', W = (1+x)^{rear} (1-x)^{front}.
template <class R>
struct InverseForm {
  R local;
  R nonlocal;
  numeric::Power<R> rear;
  numeric::Power<R> front;
};
using InverseFormula = Formula<InverseForm, SlopeCase>;

InverseFormula inverse_formula() {
  return InverseFormula::from([]<Real R>(const SlopeCase& c) {
    const Rational s = c.problem.coupled_friction(0);
    return InverseForm<R>{numeric::to_real<R>(s / (1 + s * s)), numeric::to_real<R>(1 / (1 + s * s)),
                          numeric::Power<R>::of(-(half + alpha(c.problem, 0))),
                          numeric::Power<R>::of(-(half - alpha(c.problem, 0)))};
  });
}

/// The traction of load 0 with A t = u', in closed form: with u'/Y = Q + O(1/z), t = cos(pi alpha) |Y| Q.
template <Real R>
numeric::PiecewiseDensity<R> closed_inverse(const SlopeCase& c) {
  const R a = numeric::to_real<R>(alpha(c.problem, 0));
  const R constant = numeric::to_real<R>(c.constant);
  const R linear = numeric::to_real<R>(c.linear);
  const R cosine = numeric::cos_pi_alpha<R>(c.problem.coupled_friction(0));
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
void check_inverse_case(Findings& findings, const InverseForm<R>& form, const SlopeCase& c) {
  using std::abs, std::max;
  const Quantity equation{"A t = u' for the closed form of L(u)",
                          {"(1/pi) PV int t/(x'-x) dx' + s t, trapezoidal rule", "u'"},
                          tolerance<R>()};
  const Quantity load{"L(u) carries no load", {"trapezoidal rule", "0"}, tolerance<R>()};
  const Quantity inverse_1{"L(u), trapezoidal rule", {"the formula by quadrature", "its closed form"}, tolerance<R>()};
  const Quantity inverse_2{"L(u), tanh-sinh rule", {"the formula by quadrature", "its closed form"}, tolerance<R>()};
  const R constant = numeric::to_real<R>(c.constant);
  const R linear = numeric::to_real<R>(c.linear);
  const auto slope = [=](const R& x) { return R(constant + linear * x); };
  const numeric::PiecewiseDensity<R> closed = closed_inverse<R>(c);
  const numeric::SurfaceCheck<R> surface(closed, {numeric::to_real<R>(c.problem.coupled_friction(0))},
                                         [slope](std::size_t, const auto& node) { return slope(node.x); });
  findings.compare(equation, static_cast<double>(surface.equation()));
  findings.compare(load, static_cast<double>(R(abs(surface.integral()) / (abs(constant) + abs(linear)))));

  const auto inverse_power = [](const numeric::Power<R>& p) {
    return numeric::Power<R>{R(-p.value), R(2 - p.plus_one)};
  };
  const numeric::PiecewiseDensity<R> over_weight{
      {{R(-1), R(1), R(2)}, inverse_power(form.rear), inverse_power(form.front), [=](const numeric::Node<R>& node) {
         return slope(node.x);
       }}};
  const numeric::PanelDensity<R> weight{{R(-1), R(1), R(2)}, form.rear, form.front, [](const auto&) { return R(1); }};
  const numeric::trapezoidal::Grid<R> grid(over_weight);
  bool first = true;
  for (const int percent : {40, 3, 75}) {
    const auto at = grid.midpoint_near(0, R(percent) / 100);
    const R local = form.local * slope(at.node.x);
    const auto compare = [&](const Quantity& quantity, const R& hilbert) {
      const R nonlocal = form.nonlocal * weight(at.node) * hilbert;
      const R expected = closed[0](at.node);
      const R size = max({R(abs(local)), R(abs(nonlocal)), R(abs(expected))});
      findings.compare(quantity, static_cast<double>(R(abs(local - nonlocal - expected) / size)));
    };
    compare(inverse_1, grid.hilbert(at));
    if (first) compare(inverse_2, numeric::tanh_sinh::hilbert<R>(over_weight, at).value);
    first = false;
  }
}

std::vector<Evidence> check_inverse(const Context& context, const InverseFormula& formula) {
  const auto walk = [&]<Real R>() {
    std::vector<SlopeCase> cases{{punch(Rational(3, 10), {2}), 1, Rational(1, 2)},
                                 {punch(Rational(-9, 10), {1}), 0, 1},
                                 {punch(Rational(499, 1000), {10}), 1, 0},
                                 {punch(0, {0}), 1, -2}};
    Random random(context.seed, "eq-10");
    const std::size_t count = context.quick ? 1 : count_for(context, 30, 10, 4);
    for (std::size_t k = 0; k < count; ++k) {
      const Rational nu = random.poisson();
      const Rational f = random.friction(largest_friction(context));
      const Rational constant = random.between(-1, 1);
      cases.push_back({punch(nu, {f}), constant, random.between(0, 3)});
    }
    Findings findings;
    for (const SlopeCase& c : cases) {
      findings.begin_case(text_of(c.problem) + ", u' = " + to_string(Polynomial({c.constant, c.linear})),
                          c.problem.coupled_friction(0) != 0);
      check_inverse_case(findings, formula.at<R>(c), c);
    }
    return findings.evidence("4 of a grid, " + std::to_string(count) + " random with seed " +
                             std::to_string(context.seed));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

Claim inverse_operator() {
  const InverseFormula right = inverse_formula();
  return make_claim(
      claim_text("eq-10-inverse"), check_inverse, right,
      std::vector<Wrong<InverseFormula>>{
          {"the printed (1+x)^{1/2} instead of (1+x)^{1/2+alpha}, in both places",
           right.changed(
               []<Real R>(InverseForm<R>& form, const SlopeCase&) { form.rear = numeric::Power<R>::of(-half); })},
          {"alpha of the other sign in the weight",
           right.changed([](auto& form, const SlopeCase&) { std::swap(form.rear, form.front); })},
          {"the sign of the local term", right.changed([](auto& form, const SlopeCase&) { form.local = -form.local; })},
          {"1/(1+s^2) missing before the integral",
           right.changed([](auto& form, const SlopeCase&) { form.nonlocal = 1; })},
          {"near miss: the local term moved by ten times the tolerance",
           right.changed([]<Real R>(InverseForm<R>& form, const SlopeCase&) { form.local *= 1 + near_miss<R>(); })},
          {"near miss: the integral moved by ten times the tolerance",
           right.changed(
               []<Real R>(InverseForm<R>& form, const SlopeCase&) { form.nonlocal *= 1 + near_miss<R>(); })}});
}

}  // namespace

std::vector<Claim> integral_claims() { return {published_integral(), inverse_operator()}; }

}  // namespace steadyslide::proofs_checks
