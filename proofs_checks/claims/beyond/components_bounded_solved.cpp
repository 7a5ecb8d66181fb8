#include "model/most_components.hpp"
#include "proofs_checks/instruments/solutions/contact_laws.hpp"
#include "proofs_checks/instruments/solutions/falling_contacts.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::components_bounded_solved {
namespace {

/// Returns a polynomial of degree 2 to 7 on [-1, 1] with the height 0 at `wells` places inside, and at the left end, or
/// at both ends; positive elsewhere. Under a small load contact is at all these places.
Polynomial with_wells(std::size_t wells, std::size_t ends) {
  Polynomial product = Polynomial::constant(100);
  for (std::size_t i = 0; i < wells; ++i) {
    const Polynomial factor({-Rational(2 * static_cast<int>(i) + 2, static_cast<int>(wells) + 1) + 1, 1});
    product = product * factor * factor;
  }
  if (ends > 0) product = product * Polynomial({1, 1});
  if (ends > 1) product = product * Polynomial({1, -1});
  return product;
}

/// Every other profile is one that reaches the bound under a small load and weak friction. Strong friction presses on
/// one of several places of equal height alone, until the zones are shorter than a cell.
CaseList<ContactProblem> bumps(const Context& context) {
  return random_cases(
      context, "components-bounded-solved", 240, 32, "random frictions, profiles and loads",
      [](Random& random, std::size_t k) {
        const ContactProblem random_one = random_falling_contact(random, k / 2);
        const Rational small = random.between(Rational(1, 5000), Rational(1, 500));
        const std::size_t ends = random.below(3), wells = random.below(ends == 2 ? 3 : 4);
        if (k % 2 == 0) return random_one;
        const Indenter indenter(-1, {{1, with_wells(std::max<std::size_t>(wells, ends < 2 ? 1 : 0), ends)}});
        std::vector<Rational> weak = random_one.friction().values();
        for (Rational& f : weak) f /= 20;
        return random_one.with_friction(FrictionProfile(weak, random_one.friction().jumps()))
            .with_indenter(indenter)
            .with_load(small);
      });
}

}  // namespace

Claim claim() {
  return compared<ContactProblem>("components-bounded-solved")
      .cases(bumps)
      .precision(Precision::in_double)
      .measured([](const ContactProblem& problem) -> Values {
        const auto found = solved_contact(problem, Method::cells);
        if (!found) return {};
        return {{"components", static_cast<double>(components_of(*found))}};
      })
      .predicted([](const ContactProblem& problem) -> Values {
        return {{"components", static_cast<double>(most_components(problem))}};
      })
      .wrong("near miss: one component fewer", [](Values& most) { most["components"] -= 1; })
      .wrong("the bound of a leading coefficient that is positive",
             [](Values& most, const ContactProblem& problem) {
               for (const Indenter::Piece& piece : problem.indenter().pieces()) {
                 const int degree = piece.profile.degree();
                 if (degree > 0 && degree % 2 == 0 && piece.profile.coefficients().back() < 0) most["components"] -= 1;
               }
             })
      .wrong("one polynomial for all pieces", [](Values& most, const ContactProblem& problem) {
        most["components"] -= static_cast<double>(problem.indenter().pieces().size() - 1);
      });
}

}  // namespace steadyslide::proofs_checks::components_bounded_solved
