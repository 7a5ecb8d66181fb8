#include "proofs_checks/instruments/solutions/contact_laws.hpp"
#include "proofs_checks/instruments/solutions/falling_contacts.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::friction_monotone_solved {
namespace {

/// Two problems that differ in friction, the first with the larger s.
struct TwoFrictions {
  ContactProblem larger;
  ContactProblem smaller;
  Method method;
};

std::string text_of(const TwoFrictions& c) {
  return proofs_checks::text_of(c.larger) + " and " + proofs_checks::text_of(c.smaller) + ", " +
         std::string(name_of(c.method));
}

/// Takes the growth of s in units of a random one on every piece; `mixed` changes its sign from piece to piece.
auto frictions(const Rational& growth, bool mixed = false) {
  return [=](const Context& context) {
    return random_cases(context, "friction-monotone-solved", 90, 12, "random frictions, profiles and loads",
                        [&](Random& random, std::size_t k) {
                          ContactProblem problem = random_falling_contact(random, k);
                          if (k % 3 == 2)
                            problem = with_load_at(problem, random.between(Rational(-1, 4), Rational(1, 4)));
                          // f is larger by 1, so that it may also fall.
                          std::vector<Rational> less = problem.friction().values(), more = less;
                          for (std::size_t piece = 0; piece < more.size(); ++piece) {
                            const Rational step =
                                random.below(3) == 0 ? Rational(0) : random.between(Rational(1, 50), 1);
                            more[piece] += 1 + (mixed && piece % 2 == 1 ? Rational(-step) : step) * growth;
                            less[piece] += 1;
                          }
                          const auto with = [&](const std::vector<Rational>& values) {
                            return problem.with_friction(FrictionProfile(values, problem.friction().jumps()));
                          };
                          if (problem.sliding() == Sliding::minus_x) std::swap(more, less);
                          return TwoFrictions{with(more), with(less), method_of(k)};
                        });
  };
}

}  // namespace

Claim claim() {
  return compared<TwoFrictions>("friction-monotone-solved")
      .cases(frictions(1))
      .precision(Precision::in_double)
      .measured(
          [](const TwoFrictions& c) { return values_of(compared_by(c.method, c.larger, c.smaller, friction_law)); })
      .predicted([](const TwoFrictions& c) -> Values {
        if (c.larger.load_at()) return {{"tilt", 0.0}};
        Values values{{"centre", 0.0}, {"mean", 0.0}};
        if (c.method == Method::riemann_hilbert) values.add({"ends", 0.0});
        return values;
      })
      .wrong_beyond("the frictions exchanged", frictions(Rational(-1)))
      .wrong_beyond("friction larger on some pieces and smaller on others", frictions(1, true))
      .wrong_beyond("near miss: friction less by a millionth", frictions(Rational(-1, 1'000'000)));
}

}  // namespace steadyslide::proofs_checks::friction_monotone_solved
