#pragma once
// The only place where evidence becomes a verdict.
//
//   refuted    some counterexample, whatever the other evidence is, or a rate that differs from the expected one by more
//              than its tolerance and more than its error bar
//   proved     otherwise, if there is a proof without a gap (proof/proof.hpp); agreements do not change this
//   supported  otherwise, if there is evidence and every piece of it shows something. Exact identities without a proof
//              support.
//   undecided  otherwise: no evidence, a proof with a gap, an agreement with too few effective cases, a rate whose error
//              bar is wider than its tolerance, or a statement beyond calculation
//
// A claim with a control that is not refuted was not checked: its verdict is undecided, unless it is refuted.

#include <span>
#include <string_view>

#include "proofs_checks/kit/evidence.hpp"

namespace steadyslide::proofs_checks {

enum class Verdict { refuted, undecided, supported, proved };
/// Returns "refuted", "undecided", "supported" or "proved".
std::string_view name_of(Verdict verdict);

/// True if this piece of evidence alone refutes the claim.
[[nodiscard]] bool refutes(const Evidence& evidence);

[[nodiscard]] Verdict weigh(std::span<const Evidence> evidence, bool all_controls_refuted = true);

}  // namespace steadyslide::proofs_checks
