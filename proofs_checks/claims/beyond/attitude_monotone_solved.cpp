#include "proofs_checks/instruments/solutions/contact_laws.hpp"
#include "proofs_checks/instruments/solutions/falling_contacts.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::attitude_monotone_solved {
namespace {

/// A problem with given attitude, and the slope that is added to its profile; or a problem that may tilt.
struct Attitude {
  ContactProblem problem;
  Rational slope;
  Method method;
};

std::string text_of(const Attitude& c) {
  return proofs_checks::text_of(c.problem) + ", slope " + to_string(c.slope) + ", " + std::string(name_of(c.method));
}

/// Takes the added slope in units of the usual one; if absent, it is random.
auto attitudes(const std::optional<Rational>& slope) {
  return [slope](const Context& context) {
    return random_cases(context, "attitude-monotone-solved", 90, 12, "random frictions, profiles, loads and attitudes",
                        [&](Random& random, std::size_t k) {
                          const ContactProblem problem = random_falling_contact(random, k);
                          const Rational place = random.between(Rational(-1, 4), Rational(1, 4));
                          const Rational size = random.between(Rational(1, 100), 1);
                          if (k % 3 == 2) return Attitude{with_load_at(problem, place), 0, method_of(k)};
                          return Attitude{problem, slope.value_or(size) * usual_slope(problem), method_of(k)};
                        });
  };
}

/// Returns tilts in units of the usual slope.
Values tilts(const ContactProblem& problem, const std::optional<double>& tilt) {
  if (!tilt) return {};
  return {{"tilt", *tilt / to_real<double>(usual_slope(problem))}};
}

}  // namespace

Claim claim() {
  return compared<Attitude>("attitude-monotone-solved")
      .cases(attitudes({}))
      .precision(Precision::in_double)
      .measured([](const Attitude& c) -> Values {
        if (c.problem.load_at()) return tilts(c.problem, tilt_by_bracketing(c.problem, c.method));
        const ContactProblem turned = with_profile_plus(c.problem, Polynomial({0, c.slope}));
        return values_of(compared_by(c.method, turned, c.problem, attitude_law));
      })
      .predicted([](const Attitude& c) -> Values {
        if (!c.problem.load_at()) return {{"centre", 0.0}, {"order", 0.0}, {"cumulative", 0.0}};
        const auto found = solved_contact(c.problem, c.method);
        return found ? tilts(c.problem, found->solution->tilt()->value) : Values();
      })
      .wrong_beyond("the attitudes exchanged", attitudes(Rational(-1, 2)))
      .wrong("the tilt with the opposite sign", scaled({"tilt"}, -1))
      .wrong_beyond("near miss: a slope less by a millionth of the usual one", attitudes(Rational(-1, 1'000'000)))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::attitude_monotone_solved
