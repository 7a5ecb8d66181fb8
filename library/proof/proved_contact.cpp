#include "library/proof/proved_contact.hpp"

#include <algorithm>
#include <array>

namespace steadyslide::library {
namespace {

/// True if both sets have the same ends beside the same places of the data, at distances that agree to three digits.
bool same_contact_set(const ApproximateContact& one, const ApproximateContact& other) {
  return std::ranges::equal(one.ends, other.ends, [](const auto& a, const auto& b) {
    const Rational larger = std::max(a.offset, b.offset), difference = larger - std::min(a.offset, b.offset);
    return a.anchor == b.anchor && a.beside == b.beside && a.vanishes == b.vanishes && 1000 * difference <= larger;
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
    const std::optional<FoundContact> solution = found(solved_with);
    // The proof showed that a sign is wrong with these ends. More digits of the same ends cannot change that.
    if (!solution || (refuted && same_contact_set(*refuted, solution->contact))) break;
    proof = enclosure::prove_contact(problem, solution->contact, digits, work);
    const bool is_hopeless = solved_with > 16 && !solution->is_solved;
    if (proof->proved || work.is_spent() || is_hopeless) break;
    if (proof->refuted) refuted = solution->contact;
  }
  return proof;
}

}  // namespace steadyslide::library
