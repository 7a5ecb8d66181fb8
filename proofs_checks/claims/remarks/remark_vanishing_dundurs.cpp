// Two elastic bodies whose Dundurs' constant vanishes. [Bal16, remark 1]

#include "proofs_checks/claims/remarks/remarks.hpp"
#include "proofs_checks/instruments/near.hpp"

namespace steadyslide::proofs_checks {
namespace {

struct Bodies {
  std::string name;
  Elasticity elasticity;
};

/// Equal bodies; other ones with mu_2 (kappa_1 - 1) = mu_1 (kappa_2 - 1); the same in plane stress.
std::vector<Bodies> pairs(bool quick) {
  const Solid steel(Rational(3, 10), 2);
  std::vector<Bodies> all{{"equal bodies", Elasticity(steel, steel)}};
  // (1 - 2 nu)/mu equal: nu = 3/10, mu = 10/13 and nu = 2/5, mu = 5/13.
  all.push_back({"(1 - 2 nu)/mu equal", Elasticity(steel, Solid(Rational(2, 5), Rational(14, 13)))});
  if (quick) return all;
  all.push_back({"equal bodies, plane stress", Elasticity(steel, steel, Plane::stress)});
  return all;
}

ContactProblem sliding(const Elasticity& elasticity, bool with_friction) {
  const Rational c(1, 10);
  std::vector<Rational> f{Rational(1, 2), 10};
  if (!with_friction) f = {0, 0};
  return {elasticity, FrictionProfile(std::move(f), {c}),
          Indenter(-2, {{2, Polynomial({0, Rational(1, 5), 1, 0, Rational(1, 3)})}}), 1};
}

/// What stands for Dundurs' constant in the problem with friction.
struct DundursSaid {
  enum class Elastic { both, rigid, second_dundurs, tiny } bodies = Elastic::both;
  bool shear = true;  ///< t_t = -f t is there all the same
};

Elasticity as_said(const Bodies& bodies, const DundursSaid& said, double tolerance) {
  using Elastic = DundursSaid::Elastic;
  switch (said.bodies) {
    case Elastic::both: return bodies.elasticity;
    case Elastic::rigid: return Elasticity(*bodies.elasticity.half_space(), bodies.elasticity.plane());
    // The condition kappa_1 = kappa_2 in place of the right one.
    case Elastic::second_dundurs:
      return {*bodies.elasticity.half_space(), Solid(bodies.elasticity.half_space()->poisson(), 7),
              bodies.elasticity.plane()};
    default: return Elasticity::reduced(10 * Rational(tolerance));
  }
}

/// c t in reduced quantities, at three places.
template <Real R>
std::vector<R> values(const numeric::RiemannHilbertSolution<R>& solution) {
  std::vector<R> all;
  for (const Rational& x : {Rational(-3, 10), Rational(0), Rational(1, 5)}) {
    all.push_back(solution.at(x).traction.left.value);
    all.push_back(solution.at(x).shear.left.value);
  }
  return all;
}

std::vector<Evidence> check(const Context& context, const DundursSaid& said) {
  return gather_at_fifty(context, [&]<Real R>() {
    const Quantity pressure{
        "pressure with and without friction", {"solved with friction", "solved without"}, tolerance<R>()};
    const Quantity shear{
        "tangential traction", {"solved with friction", "-f t of the frictionless one"}, tolerance<R>()};
    const Quantity power{"power at the friction jump", {"solved with friction", "0"}, tolerance<R>()};
    Findings findings;
    for (const Bodies& bodies : pairs(context.quick)) {
      findings.begin_case(bodies.name);
      const Elasticity elasticity = as_said(bodies, said, tolerance<R>());
      const ContactProblem problem = sliding(elasticity, true);
      if (said.bodies == DundursSaid::Elastic::both) {
        findings.decide("Dundurs' constant is 0", elasticity.gamma() == 0);
        findings.decide("the power at the jump is 0",
                        jump_exponent(problem.coupled_friction(0), problem.coupled_friction(1)).sign() == 0);
      }
      const auto with = solve<R>(problem);
      const auto without =
          solve<R>(sliding(said.bodies == DundursSaid::Elastic::tiny ? Elasticity::reduced(0) : elasticity, false));
      const std::vector<R> a = values(*with);
      const std::vector<R> b = values(*without);
      for (std::size_t k = 0; k < a.size(); k += 2) {
        findings.compare(pressure, relative_difference<R>(a[k], b[k]));
        const R f = numeric::to_real<R>(problem.friction().values()[k < 4 ? 0 : 1]);
        findings.compare(shear, relative_difference<R>(a[k + 1], said.shear ? R(-f * b[k]) : R(0)));
      }
      const std::size_t j = point_at(*with, problem.friction().jumps().front());
      using std::abs;
      findings.compare(power, static_cast<double>(R(abs(power_beside(*with, j, Side::left)))));
    }
    return findings.evidence("a smooth profile with free ends over a friction jump");
  });
}

}  // namespace

Claim remark_vanishing_dundurs() {
  using Elastic = DundursSaid::Elastic;
  return make_claim(
      claim_text("rem-01-vanishing-dundurs"), check, DundursSaid{},
      std::vector<Wrong<DundursSaid>>{
          {"a rigid indenter", changed<DundursSaid>([](DundursSaid& said) { said.bodies = Elastic::rigid; })},
          {"Poisson's ratios equal, shear moduli not",
           changed<DundursSaid>([](DundursSaid& said) { said.bodies = Elastic::second_dundurs; })},
          {"no tangential traction", changed<DundursSaid>([](DundursSaid& said) { said.shear = false; })},
          {"near miss: Dundurs' constant is ten times the tolerance",
           changed<DundursSaid>([](DundursSaid& said) { said.bodies = Elastic::tiny; })}});
}

}  // namespace steadyslide::proofs_checks
