#pragma once
// Proves the solution that a solver finds: first in double and, if that start is too far from the solution, with more
// digits.

#include <functional>
#include <optional>

#include "enclosure/contact/contact_proof.hpp"

namespace steadyslide::library {

/// The contact that a solver returns, with the mark of a solution.
struct FoundContact {
  ApproximateContact contact;
  bool is_solved = true;  ///< false: a condition fails; the contact is the last one that the solver reached
};

/// The contact that a solver finds with 16, 50 or 100 digits; absent if it finds none.
using ContactWithDigits = std::function<std::optional<FoundContact>(int digits)>;

/// Returns the proof to `digits` digits, or the last failed one; nothing if the first run of the solver finds nothing.
/// `first`: the digits of the first run. All attempts share one budget of work. A refuted contact set is not tried
/// again. If the solver fails with 50 digits, 100 are not tried: the budget does not count the solver's work.
std::optional<enclosure::ContactProof> proved_contact(const ContactProblem& problem, int digits, int first,
                                                      const ContactWithDigits& found);

}  // namespace steadyslide::library
