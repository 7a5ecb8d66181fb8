#include "model/elasticity.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::rem_01_elastic_indenter {
namespace {

struct TwoBodies {
  Solid half_space;
  Solid indenter;
  Plane plane;
};

std::string text_of(const Solid& body) {
  return "nu = " + to_string(body.poisson()) + ", E = " + to_string(body.young());
}
std::string text_of(const TwoBodies& c) {
  return "half-space " + text_of(c.half_space) + "; indenter " + text_of(c.indenter);
}

CaseList<TwoBodies> pairs(const Context& context) {
  CaseList<TwoBodies> list{{}, "random pairs of bodies with seed " + std::to_string(context.seed)};
  Random random(context.seed, "elastic-indenter");
  const auto solid = [&random] {
    const Rational nu = random.poisson();
    return Solid(nu, random.between(0, 10));
  };
  for (std::size_t k = 0; k < (context.quick ? 20U : 200U); ++k) {
    const Solid half_space = solid();
    list.cases.push_back({half_space, solid(), k % 2 == 0 ? Plane::strain : Plane::stress});
  }
  return list;
}

/// A constant as a function of shear moduli and Kolosov's constants, those of the half-space first.
using Constant =
    std::function<Rational(const Rational& mu1, const Rational& kappa1, const Rational& mu2, const Rational& kappa2)>;

Rational dundurs(const Rational& m1, const Rational& k1, const Rational& m2, const Rational& k2) {
  return (m2 * (k1 - 1) - m1 * (k2 - 1)) / (m2 * (k1 + 1) + m1 * (k2 + 1));
}

Rational sum_of_compliances(const Rational& m1, const Rational& k1, const Rational& m2, const Rational& k2) {
  return (k1 + 1) / (4 * m1) + (k2 + 1) / (4 * m2);
}

Values constants(const TwoBodies& c, const Constant& gamma, const Constant& compliance) {
  const auto of = [&](const Constant& constant, const Solid& one, const Solid& two) {
    return constant(one.shear_modulus(), one.kolosov(c.plane), two.shear_modulus(), two.kolosov(c.plane));
  };
  // An indenter with the stiffness 1e200 is rigid to 1e-94.
  const Solid stiff(c.indenter.poisson(), parse_rational("1e200"));
  return {{"gamma", of(gamma, c.half_space, c.indenter)},
          {"compliance", of(compliance, c.half_space, c.indenter)},
          {"exchanged", Rational(-of(gamma, c.half_space, c.indenter))},
          {"equal bodies", Rational(0)},
          {"rigid gamma", to_real<Number>(of(gamma, c.half_space, stiff))},
          {"rigid compliance", to_real<Number>(of(compliance, c.half_space, stiff))}};
}

auto with(const Constant& gamma, const Constant& compliance) {
  return [=](Values& p, const TwoBodies& c) { p = constants(c, gamma, compliance); };
}

}  // namespace

Claim claim() {
  return compared<TwoBodies>("rem-01-elastic-indenter")
      .cases(pairs)
      .measured([](const TwoBodies& c) -> Values {
        const Elasticity both(c.half_space, c.indenter, c.plane);
        const Elasticity rigid(c.half_space, c.plane);
        return {{"gamma", both.gamma()},
                {"compliance", both.compliance()},
                {"exchanged", Elasticity(c.indenter, c.half_space, c.plane).gamma()},
                {"equal bodies", Elasticity(c.half_space, c.half_space, c.plane).gamma()},
                {"rigid gamma", to_real<Number>(rigid.gamma())},
                {"rigid compliance", to_real<Number>(rigid.compliance())}};
      })
      .predicted([](const TwoBodies& c) { return constants(c, dundurs, sum_of_compliances); })
      .wrong("the bodies exchanged in `gamma`",
             with([](auto& m1, auto& k1, auto& m2, auto& k2) { return dundurs(m2, k2, m1, k1); }, sum_of_compliances))
      .wrong("`kappa + 1` in `gamma`'s numerator",
             with([](auto& m1, auto& k1, auto& m2,
                     auto& k2) { return (m2 * (k1 + 1) - m1 * (k2 + 1)) / (m2 * (k1 + 1) + m1 * (k2 + 1)); },
                  sum_of_compliances))
      .wrong("the compliance of the half-space alone",
             with(dundurs, [](auto& m1, auto& k1, auto&, auto&) { return (k1 + 1) / (4 * m1); }))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::rem_01_elastic_indenter
