#include "symbolic/statements/exact_identities.hpp"

#include "symbolic/field/rational_function.hpp"
#include "symbolic/local/coupling.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

ExactIdentity decided(const std::string& statement, const ex& lhs, const ex& rhs) {
  const RationalDecision decision = decide_equal(lhs, rhs);
  return {statement,
          canonical_text(lhs),
          canonical_text(rhs),
          decision.identical,
          {decision.nonvanishing.begin(), decision.nonvanishing.end()}};
}

void add_rigid(std::vector<DecidedStatement>& all) {
  const symbol nu("nu");
  const symbol young("E");
  const KolosovSolid strain = kolosov_solid(nu, young, Plane::strain);
  const KolosovSolid stress = kolosov_solid(nu, young, Plane::stress);
  const auto by_kolosov = [](const ex& kappa) -> ex { return (kappa - 1) / (kappa + 1); };

  all.push_back({"gamma-plane-strain",
                 decided("(kappa-1)/(kappa+1) with kappa = 3-4nu is gamma = (1-2nu)/(2(1-nu))",
                         by_kolosov(strain.kappa), coupling_constant(nu)),
                 {decided("the constant of plane stress instead", by_kolosov(stress.kappa), coupling_constant(nu)),
                  decided("a factor 2 missing in gamma", by_kolosov(strain.kappa), (1 - 2 * nu) / (1 - nu)),
                  decided("the sign of nu in gamma", by_kolosov(strain.kappa), coupling_constant(-nu)),
                  decided("kappa = 3-4nu moved by 1e-30", by_kolosov(strain.kappa + GiNaC::pow(ex(10), -30)),
                          coupling_constant(nu))}});
  all.push_back(
      {"gamma-plane-stress",
       decided("(kappa-1)/(kappa+1) with kappa = (3-nu)/(1+nu) is gamma = (1-nu)/2", by_kolosov(stress.kappa),
               coupling_constant(nu, Plane::stress)),
       {decided("the constant of plane strain instead", by_kolosov(strain.kappa), coupling_constant(nu, Plane::stress)),
        decided("gamma = (1+nu)/2", by_kolosov(stress.kappa), (1 + nu) / 2),
        decided("gamma = 1-nu", by_kolosov(stress.kappa), 1 - nu)}});
  all.push_back({"compliance-plane-strain",
                 decided("(kappa+1)/(4mu) is 2(1-nu^2)/E in plane strain", compliance(strain), compliance(nu, young)),
                 {decided("in plane stress", compliance(stress), compliance(nu, young)),
                  decided("(kappa+1)/(2mu)", 2 * compliance(strain), compliance(nu, young)),
                  decided("2(1-nu)^2/E", compliance(strain), 2 * (1 - nu) * (1 - nu) / young)}});
  all.push_back(
      {"compliance-plane-stress",
       decided("(kappa+1)/(4mu) is 2/E in plane stress", compliance(stress), compliance(nu, young, Plane::stress)),
       {decided("in plane strain", compliance(strain), compliance(nu, young, Plane::stress)),
        decided("1/E", compliance(stress), 1 / young),
        decided("(kappa-1)/(4mu)", (stress.kappa - 1) / (4 * stress.mu), compliance(nu, young, Plane::stress))}});
}

void add_range(std::vector<DecidedStatement>& all) {
  const symbol nu("nu");
  const ex gamma = coupling_constant(nu);
  const ex q = 1 - nu;

  all.push_back(
      {"gamma-decreases",
       decided("d gamma/d nu = -1/(2(1-nu)^2), negative", gamma.diff(nu), -1 / (2 * q * q)),
       {decided("increasing", gamma.diff(nu), 1 / (2 * q * q)), decided("-1/(1-nu)^2", gamma.diff(nu), -1 / (q * q)),
        decided("-1/(2(1-nu))", gamma.diff(nu), -1 / (2 * q))}});
  all.push_back(
      {"gamma-below-three-quarters",
       decided("3/4 - gamma = (1+nu)/(4(1-nu)), positive for -1 < nu < 1", ex(3) / 4 - gamma, (1 + nu) / (4 * q)),
       {decided("1 - gamma instead", 1 - gamma, (1 + nu) / (4 * q)),
        decided("(1-nu)/(4(1-nu))", ex(3) / 4 - gamma, ex(1) / 4),
        decided("(1+nu)/(2(1-nu))", ex(3) / 4 - gamma, (1 + nu) / (2 * q))}});
  all.push_back({"gamma-at-minus-one",
                 decided("gamma = 3/4 at nu = -1", gamma.subs(nu == -1), ex(3) / 4),
                 {decided("1", gamma.subs(nu == -1), 1), decided("at nu = 0", gamma.subs(nu == 0), ex(3) / 4),
                  decided("in plane stress", coupling_constant(-1, Plane::stress), ex(3) / 4)}});
  all.push_back(
      {"gamma-at-one-half",
       decided("gamma = 0 at nu = 1/2", gamma.subs(nu == ex(1) / 2), 0),
       {decided("1/4", gamma.subs(nu == ex(1) / 2), ex(1) / 4), decided("at nu = 1/3", gamma.subs(nu == ex(1) / 3), 0),
        decided("in plane stress", coupling_constant(ex(1) / 2, Plane::stress), 0)}});
}

void add_elastic_indenter(std::vector<DecidedStatement>& all) {
  const symbol nu("nu");
  const symbol young("E");
  const symbol mu1("mu_1");
  const symbol mu2("mu_2");
  const symbol kappa1("kappa_1");
  const symbol kappa2("kappa_2");
  const KolosovSolid half_space{mu1, kappa1};
  const KolosovSolid indenter{mu2, kappa2};
  const ex gamma = dundurs_constant(half_space, indenter);
  const ex total = compliance(half_space) + compliance(indenter);
  const ex rigid = (kappa1 - 1) / (kappa1 + 1);

  all.push_back({"dundurs-rigid",
                 decided("Dundurs' constant tends to (kappa_1-1)/(kappa_1+1) as mu_2 grows",
                         limit_at_infinity(gamma, mu2), rigid),
                 {decided("as mu_1 grows", limit_at_infinity(gamma, mu1), rigid),
                  decided("to (kappa_1+1)/(kappa_1-1)", limit_at_infinity(gamma, mu2), 1 / rigid),
                  decided("to the other sign", limit_at_infinity(gamma, mu2), -rigid)}});
  const KolosovSolid body = kolosov_solid(nu, young);
  all.push_back({"dundurs-rigid-plane-strain",
                 decided("Dundurs' constant of a plane-strain half-space tends to (1-2nu)/(2(1-nu)) as mu_2 grows",
                         limit_at_infinity(dundurs_constant(body, indenter), mu2), coupling_constant(nu)),
                 {decided("to the constant of plane stress", limit_at_infinity(dundurs_constant(body, indenter), mu2),
                          coupling_constant(nu, Plane::stress)),
                  decided("of a plane-stress half-space",
                          limit_at_infinity(dundurs_constant(kolosov_solid(nu, young, Plane::stress), indenter), mu2),
                          coupling_constant(nu)),
                  decided("with the bodies exchanged", limit_at_infinity(dundurs_constant(indenter, body), mu2),
                          coupling_constant(nu))}});
  all.push_back({"compliance-rigid",
                 decided("the sum of the compliances tends to (kappa_1+1)/(4mu_1) as mu_2 grows",
                         limit_at_infinity(total, mu2), compliance(half_space)),
                 {decided("as mu_1 grows", limit_at_infinity(total, mu1), compliance(half_space)),
                  decided("to the indenter's", limit_at_infinity(total, mu2), compliance(indenter)),
                  decided("to twice that", limit_at_infinity(total, mu2), 2 * compliance(half_space))}});
  all.push_back(
      {"dundurs-exchange",
       decided("exchanging the bodies changes the sign of Dundurs' constant", dundurs_constant(indenter, half_space),
               -gamma),
       {decided("and not its value", dundurs_constant(indenter, half_space), gamma),
        decided("exchanging the shear moduli only", dundurs_constant({mu2, kappa1}, {mu1, kappa2}), -gamma),
        decided("exchanging Kolosov's constants only", dundurs_constant({mu1, kappa2}, {mu2, kappa1}), -gamma)}});
  all.push_back(
      {"dundurs-identical",
       decided("two bodies of one material have Dundurs' constant 0", dundurs_constant(half_space, half_space), 0),
       {decided("of one shear modulus", dundurs_constant(half_space, {mu1, kappa2}), 0),
        decided("of one Kolosov constant", dundurs_constant(half_space, {mu2, kappa1}), 0),
        decided("the rigid limit", rigid, 0)}});
  all.push_back(
      {"dundurs-by-compliances",
       decided("Dundurs' constant times the compliance is ((kappa_1-1)/mu_1 - (kappa_2-1)/mu_2)/4", gamma * total,
               ((kappa1 - 1) / mu1 - (kappa2 - 1) / mu2) / 4),
       {decided("a sum instead of the difference", gamma * total, ((kappa1 - 1) / mu1 + (kappa2 - 1) / mu2) / 4),
        decided("kappa + 1", gamma * total, ((kappa1 + 1) / mu1 - (kappa2 + 1) / mu2) / 4),
        decided("without 1/4", gamma * total, (kappa1 - 1) / mu1 - (kappa2 - 1) / mu2)}});
}

/// With s = tan(pi alpha) the addition law makes cot pi(alpha_+ - alpha_-) rational in s_-, s_+.
void add_jump(std::vector<DecidedStatement>& all) {
  const symbol left("s_l");
  const symbol right("s_r");
  const auto cot_of_difference = [](const ex& s, const ex& t) -> ex { return (1 + s * t) / (t - s); };
  // 1 + s_- s_+ + (s_+ - s_-) cot(pi beta): the determinant of the amplitudes on both sides of a friction jump.
  const auto determinant = [&](const ex& cot) -> ex { return 1 + left * right + (right - left) * cot; };

  all.push_back({"jump-determinant",
                 decided("1 + s_l s_r + (s_r - s_l) cot(pi beta) = 0 for beta = alpha_l - alpha_r, tan(pi alpha) = s",
                         determinant(cot_of_difference(right, left)), 0),
                 {decided("beta = alpha_r - alpha_l", determinant(cot_of_difference(left, right)), 0),
                  decided("beta = alpha_l + alpha_r", determinant(cot_of_difference(-right, left)), 0),
                  decided("beta = alpha_l", determinant(1 / left), 0)}});
}

}  // namespace

std::vector<DecidedStatement> elasticity_statements() {
  std::vector<DecidedStatement> all;
  add_rigid(all);
  add_range(all);
  add_elastic_indenter(all);
  add_jump(all);
  return all;
}

}  // namespace steadyslide::symbolic
