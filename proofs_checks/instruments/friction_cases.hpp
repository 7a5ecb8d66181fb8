#pragma once
// Values of s of either sign, as both directions of sliding have it: fixed ones and random ones, a single random one in
// a quick run. For what is claimed under any constant friction.

#include "proofs_checks/kit/cases.hpp"

namespace steadyslide::proofs_checks {

struct FrictionValue {
  Rational s;
};

inline std::string text_of(const FrictionValue& c) { return "s = " + to_string(c.s); }

/// CaseList<FrictionValue>(const Context&), the random ones of this stream.
inline auto friction_values(std::string stream) {
  return [stream = std::move(stream)](const Context& context) -> CaseList<FrictionValue> {
    std::vector<FrictionValue> all{{Rational(-3, 4)}, {2}, {0}, {Rational(1, 10)}, {10}};
    Random random(context.seed, stream);
    if (context.quick) all = {{random.between(Rational(1, 2), 2)}};
    for (int k = 0; k < 6 && !context.quick; ++k) all.push_back({random.between(-3, 3)});
    return {all, "s of both signs, seed " + std::to_string(context.seed)};
  };
}

}  // namespace steadyslide::proofs_checks
