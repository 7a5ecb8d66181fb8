// An elastic indenter: Dundurs' constant in the place of gamma, the sum of compliances. [Bal16, remark 1]

#include <functional>

#include "model/elasticity.hpp"
#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/identities.hpp"
#include "proofs_checks/kit/random.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// A constant of two bodies by shear moduli and Kolosov's constants, the half-space first.
using OfBodies =
    std::function<Rational(const Rational& mu1, const Rational& kappa1, const Rational& mu2, const Rational& kappa2)>;

struct BodiesFormula {
  OfBodies gamma;
  OfBodies compliance;
  std::vector<symbolic::ExactIdentity> identities;

  BodiesFormula with_gamma(OfBodies wrong) const { return {std::move(wrong), compliance, identities}; }
  BodiesFormula with_compliance(OfBodies wrong) const { return {gamma, std::move(wrong), identities}; }
  BodiesFormula with_identity(const symbolic::ExactIdentity& wrong) const {
    BodiesFormula changed = *this;
    changed.identities.push_back(wrong);
    return changed;
  }
};

std::string text_of(const Solid& body) {
  return "nu = " + to_string(body.poisson()) + ", E = " + to_string(body.young());
}

std::vector<Evidence> check(const Context& context, const BodiesFormula& formula) {
  const Evidence decided =
      weigh_identities(formula.identities, "as rational functions of both shear moduli and both Kolosov constants");
  if (std::holds_alternative<Counterexample>(decided)) return {decided};

  Random random(context.seed, "elastic-indenter");
  const std::size_t cases = context.quick ? 20 : 200;
  for (std::size_t k = 0; k < cases; ++k) {
    const Solid body(random.poisson(), random.between(0, 10));
    const Solid indenter(random.poisson(), random.between(0, 10));
    const Plane plane = k % 2 == 0 ? Plane::strain : Plane::stress;
    const Elasticity model(body, indenter, plane);
    const auto at = [&](const OfBodies& constant, const Solid& one, const Solid& two) {
      return constant(one.shear_modulus(), one.kolosov(plane), two.shear_modulus(), two.kolosov(plane));
    };
    const std::string where = "half-space " + text_of(body) + "; indenter " + text_of(indenter);
    const Rational gamma = at(formula.gamma, body, indenter);
    const Rational compliance = at(formula.compliance, body, indenter);
    if (gamma != model.gamma() || compliance != model.compliance()) {
      return {Counterexample{where, "the formula gives " + to_string(gamma) + " and " + to_string(compliance) +
                                        ", the model " + to_string(model.gamma()) + " and " +
                                        to_string(model.compliance())}};
    }
    if (at(formula.gamma, indenter, body) != -gamma || at(formula.gamma, body, body) != 0) {
      return {Counterexample{where, "exchanging the bodies does not change gamma's sign alone"}};
    }
    // An indenter as stiff as 1e200 is rigid to 1e-94.
    const Solid stiff(indenter.poisson(), parse_rational("1e200"));
    const Elasticity rigid(body, plane);
    if (abs(at(formula.gamma, body, stiff) - rigid.gamma()) >= tiny() / 100 ||
        abs(at(formula.compliance, body, stiff) - rigid.compliance()) >= tiny() / 100) {
      return {Counterexample{where, "a stiff indenter does not tend to the rigid one"}};
    }
  }
  return {decided, Agreement{"values of gamma and of the compliance, in exact arithmetic",
                             {"the formulas", "the constants that problems are solved with"},
                             "0",
                             "0",
                             cases,
                             cases,
                             cases / 2,
                             "random pairs of bodies with seed " + std::to_string(context.seed)}};
}

}  // namespace

std::vector<Claim> elastic_indenter_claims() {
  const auto chosen = statements({"dundurs-rigid", "dundurs-rigid-plane-strain", "compliance-rigid", "dundurs-exchange",
                                  "dundurs-identical", "dundurs-by-compliances"});
  using Q = Rational;
  const BodiesFormula right{
      [](const Q& m1, const Q& k1, const Q& m2, const Q& k2) {
        return Q((m2 * (k1 - 1) - m1 * (k2 - 1)) / (m2 * (k1 + 1) + m1 * (k2 + 1)));
      },
      [](const Q& m1, const Q& k1, const Q& m2, const Q& k2) { return Q((k1 + 1) / (4 * m1) + (k2 + 1) / (4 * m2)); },
      right_identities(chosen)};
  std::vector<Wrong<BodiesFormula>> wrong{
      {"the bodies exchanged in gamma", right.with_gamma([right](const Q& m1, const Q& k1, const Q& m2, const Q& k2) {
         return right.gamma(m2, k2, m1, k1);
       })},
      {"kappa + 1 in gamma's numerator", right.with_gamma([](const Q& m1, const Q& k1, const Q& m2, const Q& k2) {
         return Q((m2 * (k1 + 1) - m1 * (k2 + 1)) / (m2 * (k1 + 1) + m1 * (k2 + 1)));
       })},
      {"the compliance of the half-space alone",
       right.with_compliance([](const Q& m1, const Q& k1, const Q&, const Q&) { return Q((k1 + 1) / (4 * m1)); })},
      {"near miss: gamma moved by 1e-94", right.with_gamma([right](const Q& m1, const Q& k1, const Q& m2, const Q& k2) {
         return Q(right.gamma(m1, k1, m2, k2) + tiny());
       })}};
  for (const symbolic::DecidedStatement& s : chosen) {
    for (const symbolic::ExactIdentity& w : s.controls) {
      wrong.push_back({s.identity.statement + ", wrongly: " + w.statement, right.with_identity(w)});
    }
  }
  return {make_claim(claim_text("rem-01-elastic-indenter"), check, right, std::move(wrong))};
}

}  // namespace steadyslide::proofs_checks
