#include "proofs_checks/instruments/solutions/contact_pairs.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::layer_friction_moves_centre {
namespace {

struct MoreFriction {
  ContactProblem less;
  std::vector<Rational> more;  ///< larger frictions
};

std::string text_of(const MoreFriction& c) {
  return proofs_checks::text_of(c.less) + ", more: f = " + to_string(c.more.front());
}

ContactProblem on_layer(const Rational& nu, const std::vector<Rational>& f, const std::vector<Rational>& jumps,
                        const Polynomial& profile) {
  const Solid solid(nu, 1);
  return ContactProblem(Elasticity(solid), FrictionProfile(f, jumps), Indenter(-1, {{1, profile}}), Rational(1, 10))
      .with_body(Body::layered({{Rational(1, 2), solid}}, std::nullopt));
}

/// The flat punch and the parabola on a layer of thickness 1/2 on a rigid base.
auto contacts(const Rational& nu, bool on_half_plane = false) {
  return [=](const Context& context) {
    auto list = first_when_quick<MoreFriction>(
        context,
        {{on_layer(nu, {Rational(1, 5)}, {}, Polynomial()), {1}},
         {on_layer(nu, {Rational(1, 4), Rational(1, 2)}, {Rational(1, 10)}, Polynomial({0, 0, Rational(3, 4)})),
          {Rational(1, 2), Rational(3, 5)}}},
        1, "a flat punch and a parabola with a friction jump");
    if (on_half_plane) {
      for (MoreFriction& c : list.cases) c.less = c.less.with_body({});
    }
    return list;
  };
}

Values measured(const MoreFriction& c) {
  Values values;
  std::vector<double> rises;
  for (const Method method : {Method::riemann_hilbert, Method::cells}) {
    const auto less = solved_contact(c.less, method);
    const auto more = solved_contact(c.less.with_friction(FrictionProfile(c.more, c.less.friction().jumps())), method);
    if (!less || !more) return {};
    const Estimate<double> from = less->solution->resultants().centre_of_pressure;
    const Estimate<double> to = more->solution->resultants().centre_of_pressure;
    values.add({"front, " + std::string(name_of(method)), from.value - to.value + from.error + to.error});
    rises.push_back(to.value - from.value);
  }
  values.add({"routes", rises[1] / rises[0]});
  return values;
}

}  // namespace

Claim claim() {
  return compared<MoreFriction>("layer-friction-moves-centre")
      .cases(contacts(Rational(49, 100)))
      .precision(Precision::in_double)
      .measured(measured)
      .predicted([](const MoreFriction&) -> Values {
        return {{"front, Riemann-Hilbert", 0.0}, {"front, cells", 0.0}, {"routes", 1.0}};
      })
      .wrong_beyond("the half-plane", contacts(Rational(49, 100), true))
      .wrong_beyond("`nu = 0`", contacts(0))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::layer_friction_moves_centre
