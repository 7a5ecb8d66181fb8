#include "proofs_checks/instruments/solutions/contact_laws.hpp"
#include "proofs_checks/instruments/solutions/falling_contacts.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::load_monotone_solved {
namespace {

struct TwoLoads {
  ContactProblem problem;
  Rational growth;
  Method method;
  Rational slope = 0;  ///< added to the profile under the larger load, in units of the usual slope
};

std::string text_of(const TwoLoads& c) {
  return proofs_checks::text_of(c.problem) + ", load times " + to_string(c.growth) + ", " +
         std::string(name_of(c.method));
}

auto loads(const std::optional<Rational>& growth, const Rational& slope = 0) {
  return [=](const Context& context) {
    return random_cases(context, "load-monotone-solved", 100, 10, "random frictions, profiles and loads",
                        [&](Random& random, std::size_t k) {
                          const ContactProblem problem = random_falling_contact(random, k);
                          const Rational larger = 1 + random.between(Rational(1, 50), 2);
                          return TwoLoads{problem, growth.value_or(larger), method_of(k), slope};
                        });
  };
}

CaseList<TwoLoads> tilting(const Context&) { return {{{tilting_bumps(), 3, Method::riemann_hilbert}}, "two bumps"}; }

}  // namespace

Claim claim() {
  return compared<TwoLoads>("load-monotone-solved")
      .cases(loads({}))
      .precision(Precision::in_double)
      .measured([](const TwoLoads& c) {
        const ContactProblem larger = c.problem.with_load(c.problem.load() * c.growth);
        const Polynomial line({0, c.slope * usual_slope(larger)});
        return values_of(compared_by(c.method, with_profile_plus(larger, line), c.problem, load_law));
      })
      .predicted([](const TwoLoads&) -> Values {
        return {{"fall", 0.0}, {"lost", 0.0}, {"gap", 0.0}, {"distance", 0.0}};
      })
      .wrong_beyond("the smaller load taken for the larger one", loads(Rational(1, 2)))
      .wrong_beyond("an indenter that may tilt", tilting)
      .wrong_beyond("another attitude under the larger load", loads({}, 1))
      .wrong("near miss: an integral that is less by a billionth of the load", replaced({{"distance", -1e-9}}))
      .wrong_beyond("near miss: the larger load less by a millionth", loads(1 - Rational(1, 1'000'000)));
}

}  // namespace steadyslide::proofs_checks::load_monotone_solved
