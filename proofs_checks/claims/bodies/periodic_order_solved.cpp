#include "proofs_checks/instruments/solutions/contact_laws.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::periodic_order_solved {
namespace {

struct TwoLoads {
  ContactProblem smaller;
  ContactProblem larger;
  Method method;
};

std::string text_of(const TwoLoads& c) {
  return proofs_checks::text_of(c.smaller) + ", load " + to_string(c.larger.load()) + ", " +
         std::string(name_of(c.method));
}

/// Takes the growth of the load and of the friction under the larger load.
auto loads(const std::optional<Rational>& growth, const Rational& friction = 0) {
  return [=](const Context& context) {
    return random_cases(
        context, "periodic-order-solved", 40, 8, "random frictions, waves and loads",
        [&](Random& random, std::size_t k) {
          std::vector<Rational> f{random.between(0, 4), random.between(0, 4)};
          const std::vector<Rational> jumps{random.between(Rational(-1, 5), Rational(1, 5))};
          // A flat punch, or waves.
          const Rational edge = k % 4 < 2 ? random.between(Rational(1, 4), Rational(2, 5)) : Rational(1, 2);
          Indenter indenter(-edge, {{edge, Polynomial()}});
          if (k % 4 >= 2) {
            indenter = indenter.with_harmonics(
                {{1, -random.between(Rational(1, 2), 1), random.between(Rational(-1, 9), Rational(1, 9))}});
          }
          const auto problem = [&](const Rational& load) {
            return ContactProblem(Elasticity::reduced(Rational(1, 2)), FrictionProfile(f, jumps), indenter, load,
                                  k % 3 == 0 ? Sliding::minus_x : Sliding::plus_x, std::nullopt, Body::periodic(1));
          };
          const Rational load = random.between(Rational(1, 10), Rational(1, 2));
          const ContactProblem smaller = problem(load);
          const Rational larger = 1 + random.between(Rational(1, 50), 1);
          for (Rational& value : f) value += friction;
          return TwoLoads{smaller, problem(load * growth.value_or(larger)), method_of(k)};
        });
  };
}

}  // namespace

Claim claim() {
  return compared<TwoLoads>("periodic-order-solved")
      .cases(loads({}))
      .precision(Precision::in_double)
      .measured([](const TwoLoads& c) { return values_of(compared_by(c.method, c.larger, c.smaller, load_law)); })
      .predicted([](const TwoLoads&) -> Values {
        return {{"fall", 0.0}, {"lost", 0.0}, {"gap", 0.0}, {"distance", 0.0}};
      })
      .wrong_beyond("the smaller load taken for the larger one", loads(Rational(1, 2)))
      .wrong_beyond("another friction under the larger load", loads({}, 4))
      .wrong("near miss: an integral that is less by a billionth of the load", replaced({{"distance", -1e-9}}))
      .wrong_beyond("near miss: the larger load less by a millionth", loads(1 - Rational(1, 1'000'000)));
}

}  // namespace steadyslide::proofs_checks::periodic_order_solved
