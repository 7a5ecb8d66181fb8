#pragma once
// A report as bytes (CBOR), sent from one process of a run to another. The bytes do not contain the claim: the receiver
// already has it.

#include <string>
#include <string_view>

#include "proofs_checks/kit/run.hpp"

namespace steadyslide::proofs_checks {

std::string to_bytes(const Report& report);

/// Returns the report on this claim from the bytes that to_bytes() of the same program made. Throws
/// nlohmann::json::exception if bytes are missing or left over.
Report report_from(std::string_view bytes, const Claim& claim);

}  // namespace steadyslide::proofs_checks
