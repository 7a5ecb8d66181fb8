#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::rem_01_vanishing_dundurs {
namespace {

struct Bodies {
  std::string name;
  Solid half_space;
  std::optional<Solid> indenter;  ///< if absent, rigid
  Plane plane = Plane::strain;
  int reaction = -1;  ///< shear on the indenter divided by that on the half-space

  Elasticity elasticity() const {
    return indenter ? Elasticity(half_space, *indenter, plane) : Elasticity(half_space, plane);
  }
};

/// Returns equal bodies; different bodies with mu_2 (kappa_1 - 1) = mu_1 (kappa_2 - 1); and equal bodies in plane
/// stress.
CaseList<Bodies> pairs(const Context& context) {
  const Solid steel(Rational(3, 10), 2);
  // (1 - 2 nu)/mu is equal: nu = 3/10, mu = 10/13 and nu = 2/5, mu = 5/13.
  return fixed_cases<Bodies>({{"equal bodies", steel, steel},
                              {"(1 - 2 nu)/mu equal", steel, Solid(Rational(2, 5), Rational(14, 13))},
                              {"equal bodies, plane stress", steel, steel, Plane::stress}},
                             2, "a smooth profile with free ends over a friction jump")(context);
}

/// Returns the cases with the same half-spaces and other indenters: change(bodies) or change(bodies, context).
template <class Change>
auto with_other_indenters(Change change) {
  return [change](const Context& context) {
    CaseList<Bodies> list = pairs(context);
    for (Bodies& bodies : list.cases) called_at(context, change, bodies);
    return list;
  };
}

const Rational jump_place(1, 10);
const std::vector<Rational> friction{Rational(1, 2), 10};

/// Formula (1) for one body: u_n' = direct H t_n - coupled t_t. [Bal16, (1)]
struct BodyConstants {
  Rational direct;
  Rational coupled;
};
BodyConstants constants_of(const Solid& body, Plane plane) {
  const Rational kappa = body.kolosov(plane);
  return {(kappa + 1) / (4 * body.shear_modulus()), (kappa - 1) / (4 * body.shear_modulus())};
}

/// Applies the frictionless t_n to both bodies, with t_t = -f t_n on one and its reaction on the other. Returns the
/// error with which their surfaces, each with its own constants, fit the profile.
template <Real R>
double misfit(const Bodies& bodies, const RiemannHilbertSolution<R>& frictionless) {
  using std::abs, std::max;
  const BodyConstants lower = constants_of(bodies.half_space, bodies.plane);
  const BodyConstants upper = bodies.indenter ? constants_of(*bodies.indenter, bodies.plane) : BodyConstants{0, 0};
  const R compliance = to_real<R>(bodies.elasticity().compliance());
  const auto& form = frictionless.form();
  const R unit = to_real<R>(form.problem().frame().unit);
  const R origin = to_real<R>(form.problem().frame().origin);
  const auto segments = segments_of(form);
  const trapezoidal::Grid<R> grid(traction_density(form));
  double worst = 0;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    for (const int percent : {3, 20, 45, 60, 80, 97}) {
      const auto at = grid.midpoint_near(k, R(percent) / 100);
      const R hilbert = grid.hilbert(at);
      const bool behind = origin + unit * at.node.x < to_real<R>(jump_place);
      const R shear = -to_real<R>(friction[behind ? 0 : 1]) * grid.density()[k](at.node);
      const R below = to_real<R>(lower.direct) * hilbert - to_real<R>(lower.coupled) * shear;
      const R above = to_real<R>(upper.direct) * hilbert - to_real<R>(upper.coupled) * (bodies.reaction * shear);
      const R profile = compliance * form.problem().slope(form.slope_at(segments[k]), at.node.x);
      const R scale = max({R(abs(below)), R(abs(above)), R(abs(profile))});
      const auto error = static_cast<double>(abs(below + above - profile) / scale);
      if (!(error <= worst)) worst = error;  // also true for NaN
    }
  }
  return worst;
}

/// Solves the problem without friction and applies its traction to both bodies with friction.
template <Real R>
Values measured(const Bodies& bodies) {
  const ContactProblem frictionless{bodies.elasticity(), FrictionProfile({0, 0}, {jump_place}),
                                    Indenter(-2, {{2, Polynomial({0, Rational(1, 5), 1, 0, Rational(1, 3)})}}), 1};
  return {{"surfaces", misfit<R>(bodies, *solve<R>(frictionless))}, {"gamma", bodies.elasticity().gamma()}};
}

}  // namespace

Claim claim() {
  return compared<Bodies>("rem-01-vanishing-dundurs")
      .cases(pairs)
      .precision(Precision::at_least_fifty)
      .measured([]<Real R>(const Bodies& bodies) { return measured<R>(bodies); })
      .predicted([](const Bodies&) {
        return Values{{"surfaces", Number(0)}, {"gamma", Rational(0)}};
      })
      .wrong_beyond("a rigid indenter", with_other_indenters([](Bodies& bodies) { bodies.indenter.reset(); }))
      .wrong_beyond("both bodies dragged the same way",
                    with_other_indenters([](Bodies& bodies) { bodies.reaction = 1; }))
      // Wrong condition: kappa_1 = kappa_2.
      .wrong_beyond("Poisson's ratios equal, shear moduli not", with_other_indenters([](Bodies& bodies) {
                      bodies.indenter = Solid(bodies.half_space.poisson(), 7);
                    }))
      .wrong_beyond("near miss: the indenter stiffer by ten times the tolerance",
                    with_other_indenters([](Bodies& bodies, const Context& context) {
                      const double step = numeric::at_precision(
                          context.digits, []<Real R>() { return static_cast<double>(near_miss<R>()); });
                      const Solid& solid = *bodies.indenter;
                      bodies.indenter = Solid(solid.poisson(), solid.young() * (1 + Rational(step)));
                    }))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::rem_01_vanishing_dundurs
