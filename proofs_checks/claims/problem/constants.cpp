// gamma, alpha and Dundurs' constant: exact statements, decided symbolically for all parameters, and compared in exact
// arithmetic with what the model computes. [Bal16, section 2, (4), remark 1]

#include <functional>

#include "model/elasticity.hpp"
#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/identities.hpp"
#include "proofs_checks/instruments/punch.hpp"
#include "symbolic/cln/cln_evaluation.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// A constant as a function of nu, the interval that it fills, and the identities that prove so.
struct RangeFormula {
  Plane plane;
  std::function<Rational(const Rational&)> gamma;
  Rational infimum;      ///< approached as nu -> 1/2
  Rational supremum;     ///< approached as nu -> -1
  std::string argument;  ///< from the identities to the interval
  std::vector<symbolic::ExactIdentity> identities;

  RangeFormula with_gamma(std::function<Rational(const Rational&)> wrong) const {
    RangeFormula changed = *this;
    changed.gamma = std::move(wrong);
    return changed;
  }
  RangeFormula with_range(const Rational& low, const Rational& high) const {
    RangeFormula changed = *this;
    changed.infimum = low;
    changed.supremum = high;
    return changed;
  }
  RangeFormula with_identity(const symbolic::ExactIdentity& wrong) const {
    RangeFormula changed = *this;
    changed.identities.push_back(wrong);
    return changed;
  }
};

std::vector<Rational> poisson_ratios(const Context& context, std::string_view stream) {
  std::vector<Rational> ratios;
  for (int k = -19; k < 10; ++k) ratios.emplace_back(k, 20);
  Random random(context.seed, stream);
  for (int k = 0; k < (context.quick ? 20 : 200); ++k) ratios.push_back(random.poisson());
  return ratios;
}

std::vector<Evidence> check_range(const Context& context, const RangeFormula& formula) {
  const Evidence decided = weigh_identities(formula.identities, formula.argument);
  if (std::holds_alternative<Counterexample>(decided)) return {decided};

  std::size_t cases = 0;
  const auto at = [](const Rational& nu) { return "nu = " + to_string(nu); };
  for (const Rational& nu : poisson_ratios(context, "range")) {
    const Rational gamma = formula.gamma(nu);
    const Rational model = Elasticity(Solid(nu, 1), formula.plane).gamma();
    if (gamma != model) {
      return {Counterexample{
          at(nu), "the formula gives " + to_string(gamma) + ", Kolosov's constants give " + to_string(model)}};
    }
    if (gamma <= formula.infimum || gamma >= formula.supremum) {
      return {Counterexample{at(nu), "gamma = " + to_string(gamma) + " lies outside of the interval"}};
    }
    const Rational further = nu + (Rational(1, 2) - nu) / 1000;
    if (formula.gamma(further) >= gamma) return {Counterexample{at(nu), "gamma does not decrease"}};
    ++cases;
  }
  // The ends are approached: no smaller interval will do.
  const Rational step = tiny() / 100;
  const Rational low = formula.gamma(Rational(1, 2) - step) - formula.infimum;
  const Rational high = formula.supremum - formula.gamma(Rational(-1) + step);
  if (low <= 0 || low >= tiny()) return {Counterexample{"nu -> 1/2", "gamma does not tend to the lower end"}};
  if (high <= 0 || high >= tiny()) return {Counterexample{"nu -> -1", "gamma does not tend to the upper end"}};
  return {decided, Agreement{"value of gamma, in exact arithmetic",
                             {"the formula", "Kolosov's constants"},
                             "0",
                             "0",
                             cases,
                             cases,
                             cases / 2,
                             "29 values of nu and random ones with seed " + std::to_string(context.seed)}};
}

Claim gamma_range() {
  const auto chosen = statements({"gamma-plane-strain", "gamma-decreases", "gamma-below-three-quarters",
                                  "gamma-at-minus-one", "gamma-at-one-half"});
  const RangeFormula right{Plane::strain,
                           [](const Rational& nu) { return Rational((1 - 2 * nu) / (2 * (1 - nu))); },
                           0,
                           Rational(3, 4),
                           "numerator and denominator of gamma and of 3/4 - gamma are positive for -1 < nu < 1/2, the "
                           "derivative is negative: gamma takes every value between its values at both ends once",
                           right_identities(chosen)};
  std::vector<Wrong<RangeFormula>> wrong{
      {"a factor 2 missing: (1-2nu)/(1-nu)",
       right.with_gamma([](const Rational& nu) { return Rational((1 - 2 * nu) / (1 - nu)); })},
      {"the sign of nu: (1+2nu)/(2(1+nu))",
       right.with_gamma([](const Rational& nu) { return Rational((1 + 2 * nu) / (2 * (1 + nu))); })},
      {"the constant of plane stress: (1-nu)/2",
       right.with_gamma([](const Rational& nu) { return Rational((1 - nu) / 2); })},
      {"the interval ]0, 1[", right.with_range(0, 1)},
      {"the interval ]0, 1/2[", right.with_range(0, Rational(1, 2))},
      {"the interval ]1/4, 3/4[", right.with_range(Rational(1, 4), Rational(3, 4))},
      {"near miss: gamma moved by 1e-94",
       right.with_gamma([](const Rational& nu) { return Rational((1 - 2 * nu) / (2 * (1 - nu)) + tiny()); })},
      {"near miss: the upper end 3/4 moved up by 1e-94", right.with_range(0, Rational(3, 4) + tiny())},
      {"near miss: the upper end 3/4 moved down by 1e-94", right.with_range(0, Rational(3, 4) - tiny())}};
  for (const symbolic::DecidedStatement& s : chosen) {
    for (const symbolic::ExactIdentity& w : s.controls) {
      wrong.push_back({s.identity.statement + ", wrongly: " + w.statement, right.with_identity(w)});
    }
  }
  return make_claim(claim_text("gamma-range"), check_range, right, std::move(wrong));
}

Claim gamma_plane_stress() {
  const auto chosen = statements({"gamma-plane-stress"});
  const RangeFormula right{
      Plane::stress,
      [](const Rational& nu) { return Rational((1 - nu) / 2); },
      Rational(1, 4),
      1,
      "gamma is linear in nu with slope -1/2: it takes every value between its values at both ends once",
      right_identities(chosen)};
  std::vector<Wrong<RangeFormula>> wrong{
      {"the sign of nu: (1+nu)/2", right.with_gamma([](const Rational& nu) { return Rational((1 + nu) / 2); })},
      {"the constant of plane strain: (1-2nu)/(2(1-nu))",
       right.with_gamma([](const Rational& nu) { return Rational((1 - 2 * nu) / (2 * (1 - nu))); })},
      {"the interval ]0, 3/4[ of plane strain", right.with_range(0, Rational(3, 4))},
      {"near miss: gamma moved by 1e-94",
       right.with_gamma([](const Rational& nu) { return Rational((1 - nu) / 2 + tiny()); })}};
  for (const symbolic::ExactIdentity& w : chosen.front().controls) {
    wrong.push_back({"wrongly: " + w.statement, right.with_identity(w)});
  }
  return make_claim(claim_text("gamma-plane-stress"), check_range, right, std::move(wrong));
}

/// alpha as an exact number, and the interval [0, supremum[.
struct AngleFormula {
  std::function<Exponent(const Rational& gamma, const Rational& f)> alpha;
  Exponent supremum;
};

std::vector<Evidence> check_angle(const Context& context, const AngleFormula& formula) {
  const auto walk = [&]<Real R>() {
    using std::cos;
    const Quantity by_cln{"value of alpha", {"arctan(gamma f)/pi", "CLN's, from nu and f"}, tolerance<R>()};
    const Quantity cosine{
        "value of cos(pi alpha)", {"the cosine of the angle", "1/sqrt(1+gamma^2 f^2)"}, tolerance<R>()};
    Findings findings;
    const std::vector<Rational> ratios = poisson_ratios(context, "alpha");
    Random random(context.seed, "alpha, friction");
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      const Rational& nu = ratios[k];
      const Rational f = k % 10 == 9 ? Rational(0) : random.between(0, k % 2 == 0 ? 2 : 50);
      findings.begin_case("nu = " + to_string(nu) + ", f = " + to_string(f), f != 0);
      const Rational gamma = Elasticity(Solid(nu, 1)).gamma();
      const Exponent alpha = formula.alpha(gamma, f);
      findings.decide("alpha >= 0, and alpha = 0 only for f = 0", alpha.sign() == (f == 0 ? 0 : 1));
      findings.decide("alpha lies below the upper end", (formula.supremum - alpha).sign() > 0);
      findings.decide("alpha increases with f", (formula.alpha(gamma, f + tiny()) - alpha).sign() > 0);
      const Exponent gap = formula.supremum - formula.alpha(gamma, 1 / (gamma * tiny()));
      findings.decide("alpha comes within 1e-94 of the upper end",
                      gap.sign() > 0 && (Exponent::angle(tiny()) - gap).sign() >= 0);
      const R value = numeric::to_real<R>(alpha);
      const auto cln = symbolic::cln_alpha(nu, f, Plane::strain, numeric::digits_served<R> + 5);
      findings.compare(by_cln, relative_difference<R>(value, numeric::to_real<R>(cln.value)));
      // With large f the cosine is as ill-conditioned as it is small.
      const R root = numeric::cos_pi_alpha<R>(gamma * f);
      findings.compare(cosine, static_cast<double>(R(abs(cos(R(numeric::pi<R>() * value)) - root))));
    }
    return findings.evidence("29 values of nu and random ones, random f, with seed " + std::to_string(context.seed));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

Claim alpha_range() {
  const AngleFormula right{[](const Rational& gamma, const Rational& f) { return Exponent::angle(gamma * f); }, half};
  const auto with = [](auto alpha) { return AngleFormula{alpha, half}; };
  return make_claim(claim_text("alpha-range"), check_angle, right,
                    std::vector<Wrong<AngleFormula>>{
                        {"the interval [0, 1/4[", {right.alpha, Exponent(Rational(1, 4))}},
                        {"the interval [0, 1[", {right.alpha, Exponent(1)}},
                        {"alpha = arctan(f)/pi, gamma missing",
                         with([](const Rational&, const Rational& f) { return Exponent::angle(f); })},
                        {"alpha = -arctan(gamma f)/pi",
                         with([](const Rational& gamma, const Rational& f) { return -Exponent::angle(gamma * f); })},
                        {"alpha = 2 arctan(gamma f)/pi", with([](const Rational& gamma, const Rational& f) {
                           return Exponent::angle(gamma * f) + Exponent::angle(gamma * f);
                         })},
                        {"near miss: alpha moved by 1e-94", with([](const Rational& gamma, const Rational& f) {
                           return Exponent::angle(gamma * f) + Exponent::angle(tiny());
                         })}});
}

}  // namespace

std::vector<Claim> constants_claims() { return {gamma_range(), gamma_plane_stress(), alpha_range()}; }

}  // namespace steadyslide::proofs_checks
