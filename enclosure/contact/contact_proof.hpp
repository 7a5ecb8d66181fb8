#pragma once
// The proof that a contact problem has a solution whose ends lie in given intervals: one zero of the conditions in a
// box (krawczyk.hpp), and every sign decided (decided_signs.hpp).

#include <optional>
#include <string>

#include "enclosure/contact/decided_signs.hpp"
#include "enclosure/contact/krawczyk.hpp"

namespace steadyslide::enclosure {

struct ContactProof {
  bool proved = false;
  /// True if a sign is decided the other way: then this is not a solution.
  bool refuted = false;
  /// The reason if nothing is proved, in words; `where` is in the user's x if the reason concerns a place.
  std::string reason;
  std::optional<double> where;

  ReducedProblem problem;
  ContactBox box;  ///< box of the unknowns; the best state reached if nothing is proved
  Bits bits;
  std::size_t intervals = 0;  ///< number of intervals on which signs were decided

  /// Returns the enclosed solution.
  TractionRepresentation form(JacobiRules& rules) const { return box.form(problem, count_for(bits), rules); }
};

/// Returns a frame in which the contact is about one unit long.
Frame frame_of(const ContactProblem& problem, const ApproximateContact& contact);

/// Proves a solver's result. `digits` is the number of digits of the ends, if the topology of the approximation is
/// correct. If the precision is not sufficient, it is raised, to at most four times what the digits need. Stops when
/// the work budget is spent.
ContactProof prove_contact(const ContactProblem& problem, const ApproximateContact& contact, int digits,
                           WorkBudget& work);
/// The same with its own budget.
ContactProof prove_contact(const ContactProblem& problem, const ApproximateContact& contact, int digits);

/// Completes a proof from the result of Krawczyk's operator: decides the signs over its box.
ContactProof prove_signs(const ReducedProblem& problem, KrawczykResult zero, JacobiRules& rules, WorkBudget& work);

/// Proves a given box, without a Newton step before the proof, with its own budget.
ContactProof prove_box(const ReducedProblem& problem, const ContactBox& box, Bits bits);

}  // namespace steadyslide::enclosure
