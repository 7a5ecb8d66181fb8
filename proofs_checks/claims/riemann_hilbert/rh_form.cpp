// The Riemann-Hilbert form on any contact set satisfies the equation.

#include "numeric/number/polynomial.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::Node;
using numeric::RiemannHilbertForm;

/// t = eps cos(pi alpha) prod |x - e_j|^{p_j} B_k on every segment.
template <class R>
struct FormTerms {
  std::shared_ptr<const TrialForm<R>> trial;
  std::vector<int> eps;
  std::vector<R> cosine;
  std::vector<numeric::Power<R>> powers;
  std::vector<std::size_t> slope;  ///< k
  bool polynomial = true;          ///< is [(g_k + tilt)/Y]_poly there?
  int integral = 1;                ///< the integral's sign
  bool excess = true;              ///< does A t miss what Y (m_0/z + ...) leaves at infinity?

  const RiemannHilbertForm<R>& form() const { return trial->form(); }
};
using FormFormula = Formula<FormTerms, Trial>;

FormFormula form_formula() {
  return FormFormula::from([]<Real R>(const Trial& trial) {
    FormTerms<R> terms{std::make_shared<const TrialForm<R>>(trial), {}, {}, {}, {}};
    const RiemannHilbertForm<R>& form = terms.form();
    terms.powers = form.fundamental_solution().powers();
    for (std::size_t k = 0; k < form.set().segments(); ++k) {
      terms.eps.push_back(form.sign(static_cast<std::ptrdiff_t>(k)));
      terms.cosine.push_back(form.problem().cos_alpha(form.friction_at(k)));
      terms.slope.push_back(form.slope_at(k));
    }
    return terms;
  });
}

/// [(g_k + tilt)/Y]_poly at x.
template <Real R>
R polynomial_part(const RiemannHilbertForm<R>& form, std::size_t slope, const R& x) {
  std::vector<R> g = form.problem().slopes()[slope];
  g.resize(std::max<std::size_t>(g.size(), 1), R(0));
  g[0] += form.tilt();
  const int degree = static_cast<int>(g.size()) - 1 - form.degree_at_infinity();
  R value = 0;
  for (int j = degree; j >= 0; --j) {
    value *= x;
    for (int i = 0; i <= degree - j; ++i) {
      const int l = form.degree_at_infinity() + j + i;
      if (l >= 0)
        value += g[static_cast<std::size_t>(l)] * form.expansion().inverse_series()[static_cast<std::size_t>(i)];
    }
  }
  return value;
}

template <Real R>
Surface<R> surface_of(const FormTerms<R>& terms) {
  const RiemannHilbertForm<R>& form = terms.form();
  const auto bracket = [&terms, &form](std::size_t k, const Node<R>& node) {
    R b = form.regular_factor(terms.slope[k], {static_cast<std::ptrdiff_t>(k), node}).value;
    if (!terms.polynomial || terms.integral < 0) {
      const R poly = polynomial_part(form, terms.slope[k], node.x);
      if (terms.integral < 0) b = 2 * (poly - numeric::value_of(form.q(), node.x) / numeric::pi<R>()) - b;
      if (!terms.polynomial) b -= poly;
    }
    return R(terms.eps[k] * terms.cosine[k] * b);
  };
  const numeric::FundamentalSolution<R> weight(form.set().panels(), terms.powers);
  const std::vector<R> rest = terms.excess ? excess(form) : std::vector<R>{};
  const auto slope_at = [&form, rest](const R& xi) {
    const R x = numeric::to_real<R>(Trial::frame().origin) + numeric::to_real<R>(Trial::frame().unit) * xi;
    return R(slope<R>(form.problem().problem(), x, x) + form.tilt() - numeric::value_of(rest, xi));
  };
  return {density_of<R>(form, weight, bracket), friction_of(form), slope_at,
          R(-numeric::pi<R>() * coefficient_at_infinity(form, -1)), load_scale(form)};
}

std::vector<Evidence> check_form(const Context& context, const FormFormula& formula) {
  const auto walk = [&]<Real R>() {
    const std::vector<Trial> all = trials(context, "rh-form", count_for(context, {20, 2, 1}), true);
    Findings findings;
    for (const Trial& trial : all) {
      findings.begin_case(trial.name + ": " + text_of(trial.problem), has_friction(trial.problem));
      const FormTerms<R> terms = formula.at<R>(trial);
      check_surface(findings, surface_of(terms), context.quick ? 1 : 2);
    }
    return findings.evidence(detail_of(context, all));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

/// Replaces the power of end j by that of the friction sliding the other way.
template <class R>
void turn_alpha(FormTerms<R>& terms, std::size_t j) {
  const auto& point = terms.form().set().point(j);
  const Exponent& exponent = terms.form().exponent(j);
  const Exponent base(Rational(point.vanishes ? 1 : -1, 2));
  terms.powers[j] = numeric::Power<R>::of(base + base - exponent);
}

}  // namespace

Claim rh_form() {
  // Plain: the formula is the solver's form, which lives at the number type it is examined in.
  const FormFormula right = form_formula();
  return make_claim(
      claim_text("rh-form"), check_form, right,
      std::vector<Wrong<FormFormula>>{
          {"eps of the other sign on one component", right.changed([](auto& terms, const Trial&) {
             std::size_t k = 0;
             while (!terms.form().set().in_contact(k)) ++k;
             for (; k < terms.eps.size() && terms.form().set().in_contact(k); ++k) terms.eps[k] = -terms.eps[k];
           })},
          {"alpha of the other sign in the power of the first end", right.changed([](auto& terms, const Trial&) {
             std::size_t j = 0;
             while (!terms.form().set().point(j).is_end()) ++j;
             turn_alpha(terms, j);
           })},
          {"cos(pi alpha) left out", right.changed([]<class R>(FormTerms<R>& terms, const Trial&) {
             for (R& c : terms.cosine) c = 1;
           })},
          {"the power of the jump left out", right.changed([]<class R>(FormTerms<R>& terms, const Trial&) {
             for (std::size_t j = 0; j < terms.powers.size(); ++j) {
               if (!terms.form().set().point(j).is_end()) terms.powers[j] = {R(0), R(1)};
             }
           })},
          {"the slope of the other side of a wedge", right.changed([](auto& terms, const Trial&) {
             for (std::size_t j = 1; j < terms.slope.size(); ++j) {
               if (terms.form().changes_polynomial(j)) terms.slope[j] = terms.slope[j - 1];
             }
           })},
          {"the integral with the other sign", right.changed([](auto& terms, const Trial&) { terms.integral = -1; })},
          {"the polynomial at infinity forgotten",
           right.changed([](auto& terms, const Trial&) { terms.excess = false; })},
          {"[(g_k + delta)/Y]_poly left out",
           right.changed([](auto& terms, const Trial&) { terms.polynomial = false; })},
          {"near miss: the last panel's traction moved by ten times the tolerance",
           right.changed([]<class R>(FormTerms<R>& terms, const Trial&) {
             terms.cosine[segments_of(terms.form()).back()] *= 1 + near_miss<R>();
           })}});
}

}  // namespace steadyslide::proofs_checks
