#pragma once
// The one place where evidence becomes a verdict.
//
//   refuted    some counterexample, whatever stands beside it, or a rate off the expected one by more than both its
//              tolerance and its error bar
//   proved     otherwise, if there is a proof without a gap (proof/proof.hpp); agreements beside it change nothing
//   supported  otherwise, if there is evidence and every piece of it says something. Exact identities without a proof
//              support.
//   undecided  otherwise: no evidence, a proof with a gap, an agreement with too few effective cases, a rate whose error
//              bar is wider than its tolerance, or a statement beyond calculation
//
// A claim whose controls are not all refuted was not checked: its verdict is undecided unless it is refuted.

#include <span>
#include <string_view>

#include "proofs_checks/kit/evidence.hpp"

namespace steadyslide::proofs_checks {

enum class Verdict { refuted, undecided, supported, proved };
/// "refuted", "undecided", "supported", "proved".
std::string_view name_of(Verdict verdict);

/// Does this piece alone refute?
[[nodiscard]] bool refutes(const Evidence& evidence);

[[nodiscard]] Verdict weigh(std::span<const Evidence> evidence, bool all_controls_refuted = true);

}  // namespace steadyslide::proofs_checks
