#include "library/proof/proved_contact.hpp"

#include <algorithm>
#include <array>

namespace steadyslide::library {
namespace {

/// True if both have the same points, each on the same side of the same place of the data, whatever the distances.
bool same_contact_set(const ApproximateContact& one, const ApproximateContact& other) {
  return std::ranges::equal(one.ends, other.ends, [](const auto& a, const auto& b) {
    return a.anchor == b.anchor && a.beside == b.beside && a.vanishes == b.vanishes;
  });
}

}  // namespace

std::optional<enclosure::ContactProof> proved_contact(const ContactProblem& problem, int digits, int first,
                                                      const ContactWithDigits& found) {
  enclosure::WorkBudget work;
  std::optional<enclosure::ContactProof> proof;
  std::optional<ApproximateContact> refuted;
  for (const int solved_with : std::array{16, 50, 100}) {
    if (solved_with < first) continue;
    const std::optional<ApproximateContact> contact = found(solved_with);
    // A sign that is decided the other way stays so with more digits of the same ends.
    if (!contact || (refuted && same_contact_set(*refuted, *contact))) break;
    proof = enclosure::prove_contact(problem, *contact, digits, work);
    if (proof->proved || work.is_spent()) break;
    if (proof->refuted) refuted = contact;
  }
  return proof;
}

}  // namespace steadyslide::library
