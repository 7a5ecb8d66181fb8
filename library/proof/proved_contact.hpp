#pragma once
// A proof from what a solver finds: in double at first, and where that is too far away to be proved, with more digits.

#include <functional>
#include <optional>

#include "enclosure/contact/contact_proof.hpp"

namespace steadyslide::library {

/// The contact that a solver returns, and whether it solves the problem.
struct FoundContact {
  ApproximateContact contact;
  bool is_solved = true;  ///< false: a condition fails; the contact is the last one that the solver reached
};

/// The contact that a solver finds with 16, 50 or 100 digits; absent if it finds none.
using ContactWithDigits = std::function<std::optional<FoundContact>(int digits)>;

/// The proof to so many digits, or the last one that failed; nothing where the solver finds nothing at first. `first`: the digits
/// to begin with. One budget of work serves all attempts. A contact set that is refuted is not tried again. If the solver
/// fails with 50 digits, 100 are not tried: the budget does not count the solver's work.
std::optional<enclosure::ContactProof> proved_contact(const ContactProblem& problem, int digits, int first,
                                                      const ContactWithDigits& found);

}  // namespace steadyslide::library
