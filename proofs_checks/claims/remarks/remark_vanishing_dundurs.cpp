// Two elastic bodies whose Dundurs' constant vanishes. [Bal16, remark 1]

#include <optional>
#include "numeric/cauchy/traction_density.hpp"
#include "proofs_checks/claims/remarks/remarks.hpp"
#include "proofs_checks/instruments/near.hpp"

#include "proofs_checks/instruments/trial.hpp"

namespace steadyslide::proofs_checks {
namespace {

struct Bodies {
  std::string name;
  Solid half_space;
  std::optional<Solid> indenter;  ///< absent: rigid
  Plane plane = Plane::strain;

  Elasticity elasticity() const {
    return indenter ? Elasticity(half_space, *indenter, plane) : Elasticity(half_space, plane);
  }
};

/// Equal bodies; other ones with mu_2 (kappa_1 - 1) = mu_1 (kappa_2 - 1); the same in plane stress.
std::vector<Bodies> pairs(bool quick) {
  const Solid steel(Rational(3, 10), 2);
  std::vector<Bodies> all{{"equal bodies", steel, steel}};
  // (1 - 2 nu)/mu equal: nu = 3/10, mu = 10/13 and nu = 2/5, mu = 5/13.
  all.push_back({"(1 - 2 nu)/mu equal", steel, Solid(Rational(2, 5), Rational(14, 13))});
  if (quick) return all;
  all.push_back({"equal bodies, plane stress", steel, steel, Plane::stress});
  return all;
}

const Rational jump_place(1, 10);
const std::vector<Rational> friction{Rational(1, 2), 10};

ContactProblem sliding(const Elasticity& elasticity, const std::vector<Rational>& f) {
  return {elasticity, FrictionProfile(f, {jump_place}),
          Indenter(-2, {{2, Polynomial({0, Rational(1, 5), 1, 0, Rational(1, 3)})}}), 1};
}

/// What stands for bodies whose Dundurs' constant vanishes.
struct DundursSaid {
  enum class Elastic { both, rigid, second_dundurs, near } bodies = Elastic::both;
  bool shear = true;  ///< t_t = -f t is there all the same
};

Bodies as_said(Bodies bodies, const DundursSaid& said, double tolerance) {
  using Elastic = DundursSaid::Elastic;
  switch (said.bodies) {
    case Elastic::both: break;
    case Elastic::rigid: bodies.indenter.reset(); break;
    // The condition kappa_1 = kappa_2 in place of the right one.
    case Elastic::second_dundurs: bodies.indenter = Solid(bodies.half_space.poisson(), 7); break;
    case Elastic::near:
      bodies.indenter = Solid(bodies.indenter->poisson(), bodies.indenter->young() * (1 + 10 * Rational(tolerance)));
  }
  return bodies;
}

/// (1) for one body: u_n' = direct H t_n - coupled t_t. [Bal16, (1)]
struct BodyConstants {
  Rational direct;
  Rational coupled;
};
BodyConstants constants_of(const Solid& body, Plane plane) {
  const Rational kappa = body.kolosov(plane);
  return {(kappa + 1) / (4 * body.shear_modulus()), (kappa - 1) / (4 * body.shear_modulus())};
}

/// The frictionless t_n on both bodies with t_t = -f t_n on one and +f t_n on the other: do their surfaces, each by its
/// own constants, fit the profile?
template <Real R>
void check_surfaces(Findings& findings, const Bodies& bodies, const numeric::RiemannHilbertSolution<R>& frictionless) {
  using std::abs, std::max;
  const Quantity equation{"slopes of both surfaces in contact under the frictionless pressure and friction",
                          {"(1) for each body with its own constants, trapezoidal rule", "the profile's"},
                          tolerance<R>()};
  const BodyConstants lower = constants_of(bodies.half_space, bodies.plane);
  const BodyConstants upper = bodies.indenter ? constants_of(*bodies.indenter, bodies.plane) : BodyConstants{0, 0};
  const R compliance = numeric::to_real<R>(bodies.elasticity().compliance());
  const auto& form = frictionless.form();
  const R unit = numeric::to_real<R>(form.problem().frame().unit);
  const R origin = numeric::to_real<R>(form.problem().frame().origin);
  const auto segments = segments_of(form);
  const numeric::trapezoidal::Grid<R> grid(numeric::traction_density(form));
  for (std::size_t k = 0; k < segments.size(); ++k) {
    for (const int percent : {3, 20, 45, 60, 80, 97}) {
      const auto at = grid.midpoint_near(k, R(percent) / 100);
      const R hilbert = grid.hilbert(at);
      const bool behind = origin + unit * at.node.x < numeric::to_real<R>(jump_place);
      const R shear = -numeric::to_real<R>(friction[behind ? 0 : 1]) * grid.density()[k](at.node);
      const R below = numeric::to_real<R>(lower.direct) * hilbert - numeric::to_real<R>(lower.coupled) * shear;
      const R above = numeric::to_real<R>(upper.direct) * hilbert + numeric::to_real<R>(upper.coupled) * shear;
      const R profile = compliance * form.problem().slope(form.slope_at(segments[k]), at.node.x);
      const R scale = max({R(abs(below)), R(abs(above)), R(abs(profile))});
      findings.compare(equation, static_cast<double>(R(abs(below + above - profile) / scale)));
    }
  }
}

std::vector<Evidence> check(const Context& context, const DundursSaid& said) {
  return gather_at_fifty(context, [&]<Real R>() {
    const Quantity shear{
        "tangential traction", {"solved with friction", "-f t of the frictionless one"}, tolerance<R>()};
    Findings findings;
    for (const Bodies& all : pairs(context.quick)) {
      findings.begin_case(all.name);
      const Bodies bodies = as_said(all, said, tolerance<R>());
      const auto without = solve<R>(sliding(bodies.elasticity(), {0, 0}));
      check_surfaces(findings, bodies, *without);
      findings.decide("Dundurs' constant is 0", bodies.elasticity().gamma() == 0);
      const auto with = solve<R>(sliding(bodies.elasticity(), friction));
      for (const Rational& x : {Rational(-3, 10), Rational(0), Rational(1, 5)}) {
        const R f = numeric::to_real<R>(friction[x < jump_place ? 0 : 1]);
        const R expected = said.shear ? R(-f * without->at(x).traction.left.value) : R(0);
        findings.compare(shear, relative_difference<R>(with->at(x).shear.left.value, expected));
      }
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
          {"near miss: the indenter stiffer by ten times the tolerance",
           changed<DundursSaid>([](DundursSaid& said) { said.bodies = Elastic::near; })}});
}

}  // namespace steadyslide::proofs_checks
