#include "proofs_checks/kit/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace steadyslide::proofs_checks {
namespace {

bool is_complete_proof(const Evidence& evidence) {
  const auto* proof = std::get_if<CheckedProof>(&evidence);
  return proof && proof->complete();
}

/// True if the evidence shows nothing: a proof with a gap, no decided identity, too few effective cases, a rate whose
/// error bar is wider than its tolerance, or a statement beyond calculation.
bool is_empty(const Evidence& evidence) {
  if (const auto* proof = std::get_if<CheckedProof>(&evidence)) return !proof->complete();
  if (const auto* identity = std::get_if<ExactIdentity>(&evidence)) return identity->identities.empty();
  if (const auto* agreement = std::get_if<Agreement>(&evidence)) {
    return agreement->effective < std::max<std::size_t>(agreement->required, 1);
  }
  if (std::holds_alternative<BeyondCalculation>(evidence)) return true;
  // This comparison also holds for an error bar that is NaN: such a rate shows nothing.
  if (const auto* rate = std::get_if<ConvergenceRate>(&evidence)) return !(rate->error_bar <= rate->tolerance);
  return false;
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  constexpr std::array<std::string_view, 4> names{"refuted", "undecided", "supported", "proved"};
  return names[static_cast<std::size_t>(verdict)];
}

bool refutes(const Evidence& evidence) {
  if (const auto* rate = std::get_if<ConvergenceRate>(&evidence)) {
    return std::abs(rate->measured - rate->expected) > std::max(rate->tolerance, rate->error_bar);
  }
  return std::holds_alternative<Counterexample>(evidence);
}

Verdict weigh(std::span<const Evidence> evidence, bool all_controls_refuted) {
  if (std::ranges::any_of(evidence, refutes)) return Verdict::refuted;
  if (!all_controls_refuted) return Verdict::undecided;
  if (std::ranges::any_of(evidence, is_complete_proof)) return Verdict::proved;
  if (evidence.empty() || std::ranges::any_of(evidence, is_empty)) return Verdict::undecided;
  return Verdict::supported;
}

}  // namespace steadyslide::proofs_checks
