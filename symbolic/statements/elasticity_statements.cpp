#include "symbolic/field/exact_identity.hpp"

#include "symbolic/field/rational_function.hpp"
#include "symbolic/field/written_identity.hpp"
#include "symbolic/local/coupling.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// Both sides of an equation, in words and as expressions.
struct Equation {
  std::string words;
  ex lhs;
  ex rhs;
};

ExactIdentity decided(const Equation& equation) {
  const auto& [words, lhs, rhs] = equation;
  const RationalDecision decision = decide_equal(lhs, rhs);
  const auto& divisors = decision.nonvanishing;
  return {words,
          canonical_text(lhs),
          canonical_text(rhs),
          decision.identical,
          {divisors.begin(), divisors.end()},
          std::make_shared<WrittenIdentity>(WrittenIdentity{{}, {{"", lhs, rhs}}})};
}

}  // namespace

std::vector<DecidedStatement> elasticity_statements() {
  const symbol nu("nu");
  const symbol young("E");
  const KolosovSolid strain = kolosov_solid(nu, young, Plane::strain);
  const KolosovSolid stress = kolosov_solid(nu, young, Plane::stress);
  const auto by_kolosov = [](const ex& kappa) -> ex { return (kappa - 1) / (kappa + 1); };
  const ex gamma = coupling_constant(nu);
  const ex q = 1 - nu;
  const symbol mu1("mu_1");
  const symbol mu2("mu_2");
  const symbol kappa1("kappa_1");
  const symbol kappa2("kappa_2");
  const KolosovSolid half_space{mu1, kappa1};
  const KolosovSolid indenter{mu2, kappa2};
  const ex dundurs = dundurs_constant(half_space, indenter);
  const ex limit = limit_at_infinity(dundurs, mu2);
  const ex total = compliance(half_space) + compliance(indenter);
  const ex rigid = (kappa1 - 1) / (kappa1 + 1);
  const symbol left("s_l");
  const symbol right("s_r");
  const auto cot_of_difference = [](const ex& s, const ex& t) -> ex { return (1 + s * t) / (t - s); };
  // 1 + s_- s_+ + (s_+ - s_-) cot(pi beta): the determinant of the amplitudes on both sides of a friction jump.
  const auto determinant = [&](const ex& cot) -> ex { return 1 + left * right + (right - left) * cot; };

  std::vector<DecidedStatement> all;
  // The first equation is right, the others are wrong variants.
  const auto add = [&](const std::string& id, const std::vector<Equation>& equations) {
    all.push_back({id, decided(equations.front()), {}});
    for (std::size_t k = 1; k < equations.size(); ++k) all.back().controls.push_back(decided(equations[k]));
  };
  add("gamma-plane-strain",
      {{"(kappa-1)/(kappa+1) with kappa = 3-4nu is gamma = (1-2nu)/(2(1-nu))", by_kolosov(strain.kappa),
        coupling_constant(nu)},
       {"the constant of plane stress instead", by_kolosov(stress.kappa), coupling_constant(nu)},
       {"a factor 2 missing in gamma", by_kolosov(strain.kappa), (1 - 2 * nu) / (1 - nu)},
       {"the sign of nu in gamma", by_kolosov(strain.kappa), coupling_constant(-nu)},
       {"kappa = 3-4nu moved by 1e-30", by_kolosov(strain.kappa + GiNaC::pow(ex(10), -30)), coupling_constant(nu)}});
  add("gamma-plane-stress",
      {{"(kappa-1)/(kappa+1) with kappa = (3-nu)/(1+nu) is gamma = (1-nu)/2", by_kolosov(stress.kappa),
        coupling_constant(nu, Plane::stress)},
       {"the constant of plane strain instead", by_kolosov(strain.kappa), coupling_constant(nu, Plane::stress)},
       {"gamma = (1+nu)/2", by_kolosov(stress.kappa), (1 + nu) / 2},
       {"gamma = 1-nu", by_kolosov(stress.kappa), 1 - nu}});
  add("compliance-plane-strain",
      {{"(kappa+1)/(4mu) is 2(1-nu^2)/E in plane strain", compliance(strain), compliance(nu, young)},
       {"in plane stress", compliance(stress), compliance(nu, young)},
       {"(kappa+1)/(2mu)", 2 * compliance(strain), compliance(nu, young)},
       {"2(1-nu)^2/E", compliance(strain), 2 * (1 - nu) * (1 - nu) / young}});
  add("compliance-plane-stress",
      {{"(kappa+1)/(4mu) is 2/E in plane stress", compliance(stress), compliance(nu, young, Plane::stress)},
       {"in plane strain", compliance(strain), compliance(nu, young, Plane::stress)},
       {"1/E", compliance(stress), 1 / young},
       {"(kappa-1)/(4mu)", (stress.kappa - 1) / (4 * stress.mu), compliance(nu, young, Plane::stress)}});
  add("gamma-decreases", {{"d gamma/d nu = -1/(2(1-nu)^2), negative", gamma.diff(nu), -1 / (2 * q * q)},
                          {"increasing", gamma.diff(nu), 1 / (2 * q * q)},
                          {"-1/(1-nu)^2", gamma.diff(nu), -1 / (q * q)},
                          {"-1/(2(1-nu))", gamma.diff(nu), -1 / (2 * q)}});
  add("gamma-below-three-quarters",
      {{"3/4 - gamma = (1+nu)/(4(1-nu)), positive for -1 < nu < 1", ex(3) / 4 - gamma, (1 + nu) / (4 * q)},
       {"1 - gamma instead", 1 - gamma, (1 + nu) / (4 * q)},
       {"(1-nu)/(4(1-nu))", ex(3) / 4 - gamma, ex(1) / 4},
       {"(1+nu)/(2(1-nu))", ex(3) / 4 - gamma, (1 + nu) / (2 * q)}});
  add("gamma-at-minus-one", {{"gamma = 3/4 at nu = -1", gamma.subs(nu == -1), ex(3) / 4},
                             {"1", gamma.subs(nu == -1), 1},
                             {"at nu = 0", gamma.subs(nu == 0), ex(3) / 4},
                             {"in plane stress", coupling_constant(-1, Plane::stress), ex(3) / 4}});
  add("gamma-at-one-half", {{"gamma = 0 at nu = 1/2", gamma.subs(nu == ex(1) / 2), 0},
                            {"1/4", gamma.subs(nu == ex(1) / 2), ex(1) / 4},
                            {"at nu = 1/3", gamma.subs(nu == ex(1) / 3), 0},
                            {"in plane stress", coupling_constant(ex(1) / 2, Plane::stress), 0}});
  const ex in_stress = coupling_constant(nu, Plane::stress);
  add("gamma-stress-decreases", {{"d gamma/d nu = -1/2 in plane stress, negative", in_stress.diff(nu), ex(-1) / 2},
                                 {"increasing", in_stress.diff(nu), ex(1) / 2},
                                 {"-1", in_stress.diff(nu), -1},
                                 {"in plane strain", gamma.diff(nu), ex(-1) / 2}});
  add("gamma-stress-at-minus-one", {{"gamma = 1 at nu = -1 in plane stress", in_stress.subs(nu == -1), 1},
                                    {"3/4", in_stress.subs(nu == -1), ex(3) / 4},
                                    {"at nu = 0", in_stress.subs(nu == 0), 1},
                                    {"in plane strain", gamma.subs(nu == -1), 1}});
  add("gamma-stress-at-one-half",
      {{"gamma = 1/4 at nu = 1/2 in plane stress", in_stress.subs(nu == ex(1) / 2), ex(1) / 4},
       {"0", in_stress.subs(nu == ex(1) / 2), 0},
       {"at nu = 1/3", in_stress.subs(nu == ex(1) / 3), ex(1) / 4},
       {"in plane strain", gamma.subs(nu == ex(1) / 2), ex(1) / 4}});
  add("dundurs-rigid", {{"Dundurs' constant tends to (kappa_1-1)/(kappa_1+1) as mu_2 grows", limit, rigid},
                        {"as mu_1 grows", limit_at_infinity(dundurs, mu1), rigid},
                        {"to (kappa_1+1)/(kappa_1-1)", limit, 1 / rigid},
                        {"to the other sign", limit, -rigid}});
  add("dundurs-rigid-plane-strain",
      {{"Dundurs' constant of a plane-strain half-space tends to (1-2nu)/(2(1-nu)) as mu_2 grows",
        limit_at_infinity(dundurs_constant(strain, indenter), mu2), coupling_constant(nu)},
       {"to the constant of plane stress", limit_at_infinity(dundurs_constant(strain, indenter), mu2),
        coupling_constant(nu, Plane::stress)},
       {"of a plane-stress half-space", limit_at_infinity(dundurs_constant(stress, indenter), mu2),
        coupling_constant(nu)},
       {"with the bodies exchanged", limit_at_infinity(dundurs_constant(indenter, strain), mu2),
        coupling_constant(nu)}});
  add("compliance-rigid", {{"the sum of the compliances tends to (kappa_1+1)/(4mu_1) as mu_2 grows",
                            limit_at_infinity(total, mu2), compliance(half_space)},
                           {"as mu_1 grows", limit_at_infinity(total, mu1), compliance(half_space)},
                           {"to the indenter's", limit_at_infinity(total, mu2), compliance(indenter)},
                           {"to twice that", limit_at_infinity(total, mu2), 2 * compliance(half_space)}});
  add("dundurs-exchange",
      {{"exchanging the bodies changes the sign of Dundurs' constant", dundurs_constant(indenter, half_space),
        -dundurs},
       {"and not its value", dundurs_constant(indenter, half_space), dundurs},
       {"exchanging the shear moduli only", dundurs_constant({mu2, kappa1}, {mu1, kappa2}), -dundurs},
       {"exchanging Kolosov's constants only", dundurs_constant({mu1, kappa2}, {mu2, kappa1}), -dundurs}});
  add("dundurs-identical",
      {{"two bodies of one material have Dundurs' constant 0", dundurs_constant(half_space, half_space), 0},
       {"of one shear modulus", dundurs_constant(half_space, {mu1, kappa2}), 0},
       {"of one Kolosov constant", dundurs_constant(half_space, {mu2, kappa1}), 0},
       {"the rigid limit", rigid, 0}});
  add("dundurs-by-compliances",
      {{"Dundurs' constant times the compliance is ((kappa_1-1)/mu_1 - (kappa_2-1)/mu_2)/4", dundurs * total,
        ((kappa1 - 1) / mu1 - (kappa2 - 1) / mu2) / 4},
       {"a sum instead of the difference", dundurs * total, ((kappa1 - 1) / mu1 + (kappa2 - 1) / mu2) / 4},
       {"kappa + 1", dundurs * total, ((kappa1 + 1) / mu1 - (kappa2 + 1) / mu2) / 4},
       {"without 1/4", dundurs * total, (kappa1 - 1) / mu1 - (kappa2 - 1) / mu2}});
  // Both surfaces under the same tractions, t_t = -f t_n: ((kappa+1)/(4 mu)) H t_n +- ((kappa-1)/(4 mu)) f t_n.
  const symbol integral("H");
  const symbol shear("ft");
  const auto slope = [&](const KolosovSolid& body, int side) -> ex {
    return compliance(body) * integral + side * (body.kappa - 1) / (4 * body.mu) * shear;
  };
  const ex both = total * (integral + dundurs * shear);
  add("dundurs-reduction",
      {{"the slopes of both surfaces add up to c (H t + gamma f t), gamma Dundurs' constant, c the sum of the compliances",
        slope(half_space, 1) + slope(indenter, -1), both},
       {"the shear with one sign on both bodies", slope(half_space, 1) + slope(indenter, 1), both},
       {"one surface alone", slope(half_space, 1), both},
       {"the difference of the slopes", slope(half_space, 1) - slope(indenter, -1), both}});
  add("dundurs-zero",
      {{"Dundurs' constant is 0 where mu_2 (kappa_1-1) = mu_1 (kappa_2-1)",
        dundurs.subs(kappa2 == 1 + mu2 * (kappa1 - 1) / mu1), 0},
       {"where mu_1 (kappa_1-1) = mu_2 (kappa_2-1)", dundurs.subs(kappa2 == 1 + mu1 * (kappa1 - 1) / mu2), 0},
       {"where mu_2 (kappa_1+1) = mu_1 (kappa_2+1)", dundurs.subs(kappa2 == -1 + mu2 * (kappa1 + 1) / mu1), 0},
       {"for bodies of one shear modulus", dundurs.subs(mu2 == mu1), 0}});
  add("jump-determinant",
      {{"1 + s_l s_r + (s_r - s_l) cot(pi beta) = 0 for beta = alpha_l - alpha_r, tan(pi alpha) = s",
        determinant(cot_of_difference(right, left)), 0},
       {"beta = alpha_r - alpha_l", determinant(cot_of_difference(left, right)), 0},
       {"beta = alpha_l + alpha_r", determinant(cot_of_difference(-right, left)), 0},
       {"beta = alpha_l", determinant(1 / left), 0}});
  return all;
}

}  // namespace steadyslide::symbolic
