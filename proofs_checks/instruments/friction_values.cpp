#include "proofs_checks/instruments/friction_values.hpp"

namespace steadyslide::proofs_checks {

std::string text_of(const FrictionValue& friction) { return "s = " + to_string(friction.s); }

bool has_friction(const FrictionValue& friction) { return friction.s != 0; }

CaseList<FrictionValue> friction_values(const Context& context, std::string_view stream) {
  std::vector<FrictionValue> all{{Rational(4, 7)}};
  if (!context.quick) all.insert(all.end(), {{0}, {Rational(3, 2)}, {Rational(-1, 3)}});
  Random random(context.seed, stream);
  all.push_back({random.between(0, 3)});
  return {all, std::to_string(all.size()) + " values of s, the last random with seed " + std::to_string(context.seed)};
}

}  // namespace steadyslide::proofs_checks
