#pragma once
// A proof from what a solver finds: in double at first, and where that is too far away to be proved, with more digits.

#include <functional>
#include <optional>

#include "enclosure/contact/contact_proof.hpp"

namespace steadyslide::library {

/// What a solver found with some number of digits.
struct FoundContact {
  ApproximateContact contact;
  bool is_solved = true;  ///< no: a condition fails, and the contact is the best one that the solver reached
};

/// The contact that a solver finds with 16, 50 or 100 digits; absent if it finds none.
using ContactWithDigits = std::function<std::optional<FoundContact>(int digits)>;

/// The proof to so many digits, or the last one that failed; nothing where the solver finds nothing at first. `first`: the digits
/// to begin with. One budget of work serves all attempts. A contact set that is refuted is not tried again, and a problem that is
/// not solved with 50 digits is not solved with 100: the budget does not count the solver's work.
std::optional<enclosure::ContactProof> proved_contact(const ContactProblem& problem, int digits, int first,
                                                      const ContactWithDigits& found);

}  // namespace steadyslide::library
