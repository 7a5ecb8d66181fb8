#pragma once
// The proof that a contact problem has a solution whose ends lie in given intervals: one zero of the conditions in a box
// (krawczyk.hpp), and every sign decided (decided_signs.hpp).

#include <optional>
#include <string>

#include "enclosure/contact/decided_signs.hpp"
#include "enclosure/contact/krawczyk.hpp"

namespace steadyslide::enclosure {

struct ContactProof {
  bool proved = false;
  /// A sign is decided the other way: this is no solution.
  bool refuted = false;
  /// Why not, in words; `where` in the user's x if it is about a place.
  std::string reason;
  std::optional<double> where;

  ReducedProblem problem;
  ContactBox box;  ///< of the unknowns; the best state reached if nothing is proved
  Bits bits;
  std::size_t intervals = 0;  ///< on which signs were decided

  /// The enclosed solution, to be asked for numbers.
  TractionRepresentation form(JacobiRules& rules) const { return box.form(problem, count_for(bits), rules); }
};

/// A frame in which the contact is about one unit long.
Frame frame_of(const ContactProblem& problem, const ApproximateContact& contact);

/// From what a solver found. `digits`: of the ends, as far as the approximation's topology is right; precision is raised
/// where it does not suffice, to four times what the digits need. Ends when the budget of work is spent.
ContactProof prove_contact(const ContactProblem& problem, const ApproximateContact& contact, int digits,
                           WorkBudget& work);
/// With a budget of its own.
ContactProof prove_contact(const ContactProblem& problem, const ApproximateContact& contact, int digits);

/// What Krawczyk's operator says, then the signs over its box.
ContactProof prove_signs(const ReducedProblem& problem, KrawczykResult zero, JacobiRules& rules, WorkBudget& work);

/// A box that is given: no Newton step before the proof. With a budget of its own.
ContactProof prove_box(const ReducedProblem& problem, const ContactBox& box, Bits bits);

}  // namespace steadyslide::enclosure
