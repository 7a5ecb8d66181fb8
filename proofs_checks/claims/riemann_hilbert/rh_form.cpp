// Checks that the Riemann-Hilbert form satisfies the equation on any contact set.

#include <map>

#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::rh_form {
namespace {

/// The formula t = eps cos(pi alpha) prod |x - e_j|^{p_j} B_k on every segment.
struct FormTerms {
  std::shared_ptr<const TrialForm<double>> trial;  ///< gives the points and segments
  std::vector<int> eps;
  std::vector<Number> cosine;
  std::map<std::size_t, Exponent> powers;  ///< replace the powers of Y
  std::vector<std::size_t> slope;          ///< index k of the slope g_k
  bool polynomial = true;                  ///< include [(g_k + tilt)/Y]_poly
  int integral = 1;                        ///< sign of the integral
  bool excess = true;                      ///< A t omits the part of Y (m_0/z + ...) that remains at infinity

  const TractionRepresentation<double>& form() const { return trial->form(); }
  bool is_contact(std::size_t k) const { return form().set().in_contact(k); }
  bool is_end(std::size_t j) const { return form().set().point(j).is_end(); }
};

FormTerms terms_of(const Trial& trial) {
  FormTerms terms{std::make_shared<const TrialForm<double>>(trial), {}, {}, {}, {}};
  const TractionRepresentation<double>& form = terms.form();
  for (std::size_t k = 0; k < form.set().segments(); ++k) {
    terms.eps.push_back(form.sign(static_cast<std::ptrdiff_t>(k)));
    terms.cosine.push_back(cos_pi_alpha<Number>(trial.problem.coupled_friction(form.friction_at(k))));
    terms.slope.push_back(form.slope_at(k));
  }
  return terms;
}

/// Returns [(g_k + tilt)/Y]_poly at x.
template <Real R>
R polynomial_part(const TractionRepresentation<R>& form, std::size_t slope, const R& x) {
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
Surface<R> surface_of(const TractionRepresentation<R>& form, const FormTerms& terms) {
  const auto bracket = [&terms, &form](std::size_t k, const Node<R>& node) {
    R b = form.regular_factor(terms.slope[k], {static_cast<std::ptrdiff_t>(k), node}).value;
    if (!terms.polynomial || terms.integral < 0) {
      const R poly = polynomial_part(form, terms.slope[k], node.x);
      if (terms.integral < 0) b = 2 * (poly - value_of(form.q(), node.x) / numeric::pi<R>()) - b;
      if (!terms.polynomial) b -= poly;
    }
    return R(terms.eps[k] * R(terms.cosine[k]) * b);
  };
  std::vector<numeric::Power<R>> powers = form.fundamental_solution().powers();
  for (const auto& [j, exponent] : terms.powers) powers[j] = numeric::Power<R>::of(exponent);
  const numeric::FundamentalSolution<R> weight(form.set().panels(), std::move(powers));
  const std::vector<R> rest = terms.excess ? excess(form) : std::vector<R>{};
  const auto slope_at = [&form, rest](const R& xi) {
    const R x = to_real<R>(Trial::frame().origin) + to_real<R>(Trial::frame().unit) * xi;
    return R(slope<R>(form.problem().problem(), x, x) + form.tilt() - value_of(rest, xi));
  };
  return {density_of<R>(form, weight, bracket), friction_of(form), slope_at,
          R(-numeric::pi<R>() * coefficient_at_infinity(form, -1)), load_scale(form)};
}

}  // namespace

Claim claim() {
  return formula_claim<Trial, FormTerms>("rh-form")
      .cases(trials("rh-form", {20, 2, 1}, true))
      .effective_where([](const Trial& trial) { return has_friction(trial.problem); })
      .says(terms_of)
      .checked([]<Real R>(Findings& findings, const FormTerms& terms, const Trial& trial, const Context& context) {
        const TrialForm<R> tried(trial);
        check_surface(findings, surface_of(tried.form(), terms), context.quick ? 1 : 2);
      })
      .wrong("`eps` of the other sign on one component",
             [](FormTerms& terms) {
               std::size_t k = 0;
               while (!terms.is_contact(k)) ++k;
               for (; k < terms.eps.size() && terms.is_contact(k); ++k) terms.eps[k] = -terms.eps[k];
             })
      .wrong("`alpha` of the other sign in the power of the first end",
             [](FormTerms& terms) {
               std::size_t j = 0;
               while (!terms.is_end(j)) ++j;
               // The power for sliding in the opposite direction.
               const Exponent base(Rational(terms.form().set().point(j).vanishes ? 1 : -1, 2));
               terms.powers[j] = base + base - terms.form().exponent(j);
             })
      .wrong("`cos(pi alpha)` left out", [](FormTerms& terms) { std::ranges::fill(terms.cosine, 1); })
      .wrong("the power of the jump left out",
             [](FormTerms& terms) {
               for (std::size_t j = 0; j < terms.form().set().points().size(); ++j) {
                 if (!terms.is_end(j)) terms.powers[j] = Exponent();
               }
             })
      .wrong("the slope of the other side of a wedge",
             [](FormTerms& terms) {
               for (std::size_t j = 1; j < terms.slope.size(); ++j) {
                 if (terms.form().changes_polynomial(j)) terms.slope[j] = terms.slope[j - 1];
               }
             })
      .wrong("the integral with the other sign", &FormTerms::integral, -1)
      .wrong("the polynomial at infinity forgotten", &FormTerms::excess, false)
      .wrong("[(g_k + delta)/Y]_poly left out", &FormTerms::polynomial, false)
      .near_miss("the last panel's traction", [](FormTerms& terms, const Number& step) {
        terms.cosine[segments_of(terms.form()).back()] *= 1 + step;
      });
}

}  // namespace steadyslide::proofs_checks::rh_form
