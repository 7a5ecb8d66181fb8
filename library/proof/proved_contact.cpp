#include "library/proof/proved_contact.hpp"

#include <array>

namespace steadyslide::library {

std::optional<enclosure::ContactProof> proved_contact(const ContactProblem& problem, int digits, int first,
                                                      const ContactWithDigits& found) {
  enclosure::WorkBudget work;
  std::optional<enclosure::ContactProof> proof;
  for (const int solved_with : std::array{16, 50, 100}) {
    if (solved_with < first) continue;
    const std::optional<ApproximateContact> contact = found(solved_with);
    if (!contact) break;
    proof = enclosure::prove_contact(problem, *contact, digits, work);
    if (proof->proved || work.is_spent()) break;
  }
  return proof;
}

}  // namespace steadyslide::library
