#pragma once
// Values of s = gamma f at which a calculation under one friction value is examined.

#include "proofs_checks/kit/cases.hpp"

namespace steadyslide::proofs_checks {

struct FrictionValue {
  Rational s;
};

std::string text_of(const FrictionValue& friction);
bool has_friction(const FrictionValue& friction);

/// Four fixed ones (one in a quick run) and a random one.
CaseList<FrictionValue> friction_values(const Context& context, std::string_view stream);

}  // namespace steadyslide::proofs_checks
