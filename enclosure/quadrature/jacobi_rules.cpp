#include "enclosure/quadrature/jacobi_rules.hpp"

namespace steadyslide::enclosure {
namespace {

/// Of balls as objects, not of the numbers in them.
int order(const Ball& a, const Ball& b) {
  const int midpoints = arf_cmp(arb_midref(a.get()), arb_midref(b.get()));
  return midpoints != 0 ? midpoints : mag_cmp(arb_radref(a.get()), arb_radref(b.get()));
}

}  // namespace

bool JacobiRules::Before::operator()(const Key& a, const Key& b) const {
  if (a.count != b.count) return a.count < b.count;
  const int lefts = order(a.left, b.left);
  return lefts != 0 ? lefts < 0 : order(a.right, b.right) < 0;
}

const JacobiRule& JacobiRules::operator()(int count, const Ball& left, const Ball& right) {
  const Key key{count, left, right};
  const std::lock_guard lock(in_use_);
  auto place = rules_.find(key);
  if (place == rules_.end()) place = rules_.emplace(key, JacobiRule(count, left, right, bits_)).first;
  return place->second;
}

}  // namespace steadyslide::enclosure
