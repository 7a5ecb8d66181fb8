#include "proofs_checks/instruments/solutions/contact_laws.hpp"
#include "proofs_checks/instruments/solutions/falling_contacts.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::layer_order_solved {
namespace {

/// The changes of the data, 1 for those of the statement.
struct Changes {
  Rational load = 1, slope = 1, friction = 1;
};

struct OnLayers {
  ContactProblem problem;
  Method method;
  Changes changes;
};

std::string text_of(const OnLayers& c) {
  return proofs_checks::text_of(c.problem) + ", " + std::string(name_of(c.method));
}

ContactProblem random_problem(Random& random, std::size_t k) {
  const auto solid = [&] { return Solid(random.between(0, Rational(49, 100)), random.between(Rational(1, 3), 5)); };
  std::vector<Layer> layers;
  for (std::size_t layer = 0; layer < 1 + k % 2; ++layer) {
    layers.push_back(
        {random.between(Rational(1, 4), 4), solid(), random.below(4) == 0 ? Interface::slip : Interface::bonded});
  }
  std::optional<Solid> base;
  if (k % 3 != 0) base = solid();
  const Rational curve = random.between(Rational(1, 3), 1);
  const Polynomial profile = k % 5 == 4 ? Polynomial({0, 0, -curve, 0, 4 * curve}) : Polynomial({0, 0, curve});
  const Rational load = layers.front().solid.young() * random.between(Rational(1, 50), Rational(1, 5));
  return {Elasticity(layers.front().solid),
          FrictionProfile({random.between(0, 1), random.between(0, 1)},
                          {random.between(Rational(-3, 10), Rational(3, 10))}),
          Indenter(-1, {{1, profile}}),
          load,
          k % 4 < 2 ? Sliding::plus_x : Sliding::minus_x,
          std::nullopt,
          Body::layered(layers, base)};
}

auto on_layers(const Changes& changes = {}) {
  return [=](const Context& context) {
    return random_cases(context, "layer-order-solved", 16, 4, "random layers, frictions and loads",
                        [&](Random& random, std::size_t k) {
                          return OnLayers{random_problem(random, k), method_of(k / 2), changes};
                        });
  };
}

Values measured(const OnLayers& c) {
  const auto first = solved_contact(c.problem, c.method);
  const auto solved = [&](const ContactProblem& other) { return solved_contact(other, c.method); };
  const auto heavier = solved(c.problem.with_load(c.problem.load() * (1 + c.changes.load * Rational(3, 10))));
  const auto turned = solved(with_profile_plus(c.problem, Polynomial({0, c.changes.slope / 50})));
  std::vector<Rational> friction = c.problem.friction().values();
  // s is larger with more friction towards +x and with less towards -x.
  const Rational sign = c.problem.sliding() == Sliding::plus_x ? 1 : -1;
  for (Rational& f : friction) f += 1 + sign * c.changes.friction * Rational(1, 5);
  const ContactProblem rough = c.problem.with_friction(FrictionProfile(friction, c.problem.friction().jumps()));
  for (Rational& f : friction) f -= sign * c.changes.friction * Rational(1, 5);
  const auto more = solved(rough);
  const auto less = solved(c.problem.with_friction(FrictionProfile(friction, c.problem.friction().jumps())));
  if (!first || !heavier || !turned || !more || !less) return {};
  Values values = values_of(load_law(*heavier, *first));
  const auto add = [&](const std::string& law, const Shortfalls& shortfalls) {
    for (const auto& [name, value] : shortfalls) {
      if (name == law) values.add({name, value});
    }
  };
  add("centre", attitude_law(*turned, *first));
  add("mean", friction_law(*more, *less));
  return values;
}

}  // namespace

Claim claim() {
  return compared<OnLayers>("layer-order-solved")
      .cases(on_layers())
      .precision(Precision::in_double)
      .measured(measured)
      .predicted([](const OnLayers&) -> Values {
        return {{"fall", 0.0}, {"lost", 0.0}, {"gap", 0.0}, {"distance", 0.0}, {"centre", 0.0}, {"mean", 0.0}};
      })
      .wrong_beyond("a smaller load for the larger one", on_layers({.load = -1}))
      .wrong_beyond("the profile turned the other way", on_layers({.slope = -1}))
      .wrong_beyond("less friction for more", on_layers({.friction = -1}))
      .wrong("near miss: an integral that is less by a millionth of the load", replaced({{"distance", -1e-6}}));
}

}  // namespace steadyslide::proofs_checks::layer_order_solved
