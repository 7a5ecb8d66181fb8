#include "model/friction_profile.hpp"

#include <algorithm>
#include <string>

#include "model/invalid_data.hpp"

namespace steadyslide {

FrictionProfile::FrictionProfile(std::vector<Rational> values, std::vector<Rational> jumps)
    : values_(std::move(values)), jumps_(std::move(jumps)) {
  if (values_.empty()) {
    throw InvalidData("friction.values", "no friction value", "there is at least one", "0 values");
  }
  if (jumps_.size() + 1 != values_.size()) {
    throw InvalidData("friction.jumps", "wrong number of jumps", "there is one jump fewer than friction values",
                      std::to_string(values_.size()) + " values, " + std::to_string(jumps_.size()) + " jumps");
  }
  for (std::size_t k = 0; k < values_.size(); ++k) {
    if (values_[k] < 0) {
      throw InvalidData("friction.values[" + std::to_string(k) + "]", "negative friction coefficient",
                        "a friction coefficient is at least 0", to_string(values_[k]));
    }
  }
  for (std::size_t k = 1; k < jumps_.size(); ++k) {
    if (jumps_[k] <= jumps_[k - 1]) {
      throw InvalidData("friction.jumps[" + std::to_string(k) + "]", "jumps not in order",
                        "jumps increase from left to right",
                        to_string(jumps_[k]) + " after " + to_string(jumps_[k - 1]));
    }
  }
}

std::size_t FrictionProfile::piece(const Rational& x, Side side) const {
  const auto after = side == Side::left ? std::lower_bound(jumps_.begin(), jumps_.end(), x)
                                        : std::upper_bound(jumps_.begin(), jumps_.end(), x);
  return static_cast<std::size_t>(after - jumps_.begin());
}

FrictionProfile FrictionProfile::moved(const Rational& scale, const Rational& shift) const {
  std::vector<Rational> values = values_;
  std::vector<Rational> jumps;
  for (const Rational& c : jumps_) jumps.push_back(scale * c + shift);
  if (scale < 0) {
    std::reverse(values.begin(), values.end());
    std::reverse(jumps.begin(), jumps.end());
  }
  return FrictionProfile(std::move(values), std::move(jumps));
}

FrictionProfile FrictionProfile::with_jump(const Rational& c, const Rational& height) const {
  const auto at = static_cast<std::ptrdiff_t>(piece(c, Side::left));
  std::vector<Rational> values = values_;
  std::vector<Rational> jumps = jumps_;
  values.insert(values.begin() + at + 1, values_[piece(c, Side::left)] + height);
  jumps.insert(jumps.begin() + at, c);
  return FrictionProfile(std::move(values), std::move(jumps));
}

}  // namespace steadyslide
