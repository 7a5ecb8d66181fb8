#pragma once
// Values of s = gamma f for claims with one friction value.

#include "proofs_checks/kit/cases.hpp"

namespace steadyslide::proofs_checks {

struct FrictionValue {
  Rational s;
};

inline std::string text_of(const FrictionValue& friction) { return "s = " + to_string(friction.s); }
inline bool is_coupled(const FrictionValue& friction) { return friction.s != 0; }

/// Returns four fixed values and a random one. A quick run has one fixed value.
inline CaseList<FrictionValue> friction_values(const Context& context, std::string_view stream) {
  std::vector<FrictionValue> all{{Rational(4, 7)}};
  if (!context.quick) all.insert(all.end(), {{0}, {Rational(3, 2)}, {Rational(-1, 3)}});
  Random random(context.seed, stream);
  all.push_back({random.between(0, 3)});
  return {all,
          std::to_string(all.size()) + " values of `s`, the last random with seed " + std::to_string(context.seed)};
}

/// Returns fixed and random values of both signs, for both directions of sliding. A quick run has one random value.
inline CaseList<FrictionValue> frictions_of_both_signs(const Context& context, std::string_view stream) {
  std::vector<FrictionValue> all{{Rational(-3, 4)}, {2}, {0}, {Rational(1, 10)}, {10}};
  Random random(context.seed, stream);
  if (context.quick) all = {{random.between(Rational(1, 2), 2)}};
  for (int k = 0; k < 6 && !context.quick; ++k) all.push_back({random.between(-3, 3)});
  return {all, "`s` of both signs, seed " + std::to_string(context.seed)};
}

}  // namespace steadyslide::proofs_checks
