#pragma once
// Values of s = gamma f at which a calculation under one friction value is examined.

#include "proofs_checks/kit/cases.hpp"

namespace steadyslide::proofs_checks {

struct FrictionValue {
  Rational s;
};

inline std::string text_of(const FrictionValue& friction) { return "s = " + to_string(friction.s); }
inline bool is_coupled(const FrictionValue& friction) { return friction.s != 0; }

/// Four fixed ones (one in a quick run) and a random one.
inline CaseList<FrictionValue> friction_values(const Context& context, std::string_view stream) {
  std::vector<FrictionValue> all{{Rational(4, 7)}};
  if (!context.quick) all.insert(all.end(), {{0}, {Rational(3, 2)}, {Rational(-1, 3)}});
  Random random(context.seed, stream);
  all.push_back({random.between(0, 3)});
  return {all,
          std::to_string(all.size()) + " values of `s`, the last random with seed " + std::to_string(context.seed)};
}

/// Fixed and random ones of either sign, as both directions of sliding have it; a single random one in a quick run.
inline CaseList<FrictionValue> frictions_of_both_signs(const Context& context, std::string_view stream) {
  std::vector<FrictionValue> all{{Rational(-3, 4)}, {2}, {0}, {Rational(1, 10)}, {10}};
  Random random(context.seed, stream);
  if (context.quick) all = {{random.between(Rational(1, 2), 2)}};
  for (int k = 0; k < 6 && !context.quick; ++k) all.push_back({random.between(-3, 3)});
  return {all, "`s` of both signs, seed " + std::to_string(context.seed)};
}

}  // namespace steadyslide::proofs_checks
