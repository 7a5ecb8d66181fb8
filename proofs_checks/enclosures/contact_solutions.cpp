// Single contact problems. Krawczyk's method proves that the conditions have one zero close to a solver's result, and
// every sign of the traction and of the gap is decided (enclosure/contact/contact_proof.hpp). Wrong variant: contact on
// the whole support.

#include "enclosure/contact/contact_proof.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "proofs_checks/enclosures/enclosure_list.hpp"

namespace steadyslide::proofs_checks {
namespace {

constexpr int contact_digits = 30;

Decision decided_contact(const ContactProblem& problem, const ApproximateContact& contact) {
  const enclosure::ContactProof proof = enclosure::prove_contact(problem, contact, contact_digits);
  if (proof.refuted) return {Truth::no, {proof.reason}};
  if (!proof.proved) return {Truth::unknown, {proof.reason}};
  return {Truth::yes,
          {std::to_string(contact.ends.size() / 2) + " components, signs decided on " +
           std::to_string(proof.intervals) + " intervals"}};
}

Enclosure contact_of(const std::string& id, const ContactProblem& problem, std::size_t components) {
  return {id,
          [=](const Box&) -> Decision {
            const auto solution = numeric::riemann_hilbert<double>(problem).solution;
            if (!solution) return {Truth::unknown, {"no solution found"}};
            const ApproximateContact found = solution->approximate_contact();
            if (found.ends.size() != 2 * components) return {Truth::unknown, {"another number of components"}};
            return decided_contact(problem, found);
          },
          {{"the whole support in contact", [=](const Box&) {
              return decided_contact(problem, ApproximateContact{{{-1}, {1}}});
            }}}};
}

const Elasticity& certified_body() {
  static const Elasticity elasticity(Solid(Rational(1, 5), 1));
  return elasticity;
}

}  // namespace

Enclosure contact_over_notch() {
  const Rational flank(1, 5);
  const Indenter notch(-1, {{0, Polynomial({0, flank})}, {1, Polynomial({0, -flank})}});
  return contact_of(
      "contact-over-notch",
      {certified_body(), FrictionProfile({Rational(1, 10), Rational(1, 2)}, {0}), notch, Rational(3029, 1000)}, 2);
}

Enclosure contact_of_two_wells() {
  const Indenter wells(-1, {{1, Polynomial({0, Rational(1, 100), Rational(-3, 2), 0, 2})}});
  return contact_of(
      "contact-of-two-wells",
      {certified_body(), FrictionProfile({Rational(1, 2), 1, Rational(1, 5)}, {Rational(-1, 2), Rational(1, 3)}), wells,
       Rational(1, 100)},
      2);
}

Enclosure contact_of_bowl() {
  const Indenter bowl(-1, {{1, Polynomial({0, 0, Rational(1, 2)})}});
  return contact_of("contact-of-bowl",
                    {certified_body(), FrictionProfile({Rational(1, 5), 1}, {Rational(1, 10)}), bowl, Rational(1, 10)},
                    1);
}

}  // namespace steadyslide::proofs_checks
