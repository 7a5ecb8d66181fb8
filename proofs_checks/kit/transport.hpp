#pragma once
// A report as bytes (CBOR), for the way from one process of a run to another. The claim is not in it: who asked has it.

#include <string>
#include <string_view>

#include "proofs_checks/kit/run.hpp"

namespace steadyslide::proofs_checks {

std::string to_bytes(const Report& report);

/// The report on this claim, from to_bytes() of the same program. Throws nlohmann::json::exception if bytes are missing or
/// left over.
Report report_from(std::string_view bytes, const Claim& claim);

}  // namespace steadyslide::proofs_checks
