#pragma once
// A proof from what a solver finds: in double at first, and where that is too far away to be proved, with more digits.

#include <functional>
#include <optional>

#include "enclosure/contact/contact_proof.hpp"

namespace steadyslide::library {

/// The contact that a solver finds with 16, 50 or 100 digits; absent if it finds none.
using ContactWithDigits = std::function<std::optional<ApproximateContact>(int digits)>;

/// The proof to so many digits, or the last one that failed; nothing where the solver finds nothing at first. `first`: the digits
/// to begin with. One budget of work serves all attempts. A contact set that is refuted is not tried again.
std::optional<enclosure::ContactProof> proved_contact(const ContactProblem& problem, int digits, int first,
                                                      const ContactWithDigits& found);

}  // namespace steadyslide::library
