#include "enclosure/quadrature/outside_points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace steadyslide::enclosure {
namespace {

/// Returns an upper bound of |log x| for x > 0, from the exponents of two.
Ball log_size(const Ball& x) {
  mag_t low, high;
  mag_init(low);
  mag_init(high);
  arb_get_mag_lower(low, x.get());
  arb_get_mag(high, x.get());
  // 2^(e-1) <= m < 2^e for a number of exponent e; log 2 < 1.
  Ball result(0, 64);
  if (mag_is_special(low) || mag_is_special(high)) {
    result = Ball::unknown(64);
  } else {
    Ball lower(0, 64);
    arb_set_fmpz(result.get(), MAG_EXPREF(high));
    arb_set_fmpz(lower.get(), MAG_EXPREF(low));
    result = max(abs(result), abs(lower - 1));
  }
  mag_clear(low);
  mag_clear(high);
  return result;
}

/// Returns 1 to 8 if the power is certainly this integer; otherwise 0.
int small_whole(const Ball& power) {
  if (arb_is_int(power.get()) == 0 || !(power >= 1 && power <= 8)) return 0;
  return static_cast<int>(std::lround(power.to_double()));
}

bool same_midpoint(const Ball& a, const Ball& b) { return arf_equal(arb_midref(a.get()), arb_midref(b.get())) != 0; }

}  // namespace

OutsideProduct::OutsideProduct(std::vector<OutsidePoint> points) : points_(std::move(points)) {
  for (std::size_t j = 0; j < points_.size(); ++j) {
    const Ball& power = points_[j].power;
    if (power.is_zero()) continue;
    const bool negative = !power.midpoint().is_positive();
    const Ball size = abs(power.midpoint());
    // An integer in a ball with a radius needs logarithms.
    const int whole = small_whole(abs(power));
    auto group = std::find_if(groups_.begin(), groups_.end(), [&](const Group& other) {
      return other.whole == whole && same_midpoint(other.power, size);
    });
    if (group == groups_.end()) group = groups_.insert(group, Group{size, whole, {}});
    group->factors.push_back({j, negative});
  }
}

Ball OutsideProduct::at(const Ball& from_left, const Ball& from_right) const {
  const Bits bits = std::max(from_left.bits(), from_right.bits());
  Ball plain(1, bits), exponent(0, bits), error(0, 64);
  bool has_exponent = false;
  for (const Group& group : groups_) {
    Ball product(1, bits), divisor(1, bits);
    for (const Factor& factor : group.factors) {
      const OutsidePoint& point = points_[factor.point];
      const Ball distance = point.distance + (point.side == Side::left ? from_left : from_right);
      if (!distance.is_positive()) return Ball::unknown(bits);
      (factor.divides ? divisor : product) *= distance;
      if (arb_is_exact(point.power.get()) == 0) error += point.power.radius().at(64) * log_size(distance);
    }
    product /= divisor;
    if (group.whole != 0) {
      plain *= power(product, group.whole);
    } else {
      exponent += group.power * log(product);
      has_exponent = true;
    }
  }
  return has_exponent ? plain * exp(Ball::plus_or_minus(exponent, error)) : plain;
}

Ball OutsideProduct::bound(const Ball& length, const Ball& reach) const {
  Ball result(1, 64);
  for (const OutsidePoint& point : points_) {
    const Ball nearest = (point.distance.at(64) - reach.at(64)).lower();
    if (!nearest.is_positive()) return Ball::unknown(64);
    if (point.power.is_zero()) continue;
    const Ball farthest = (point.distance.at(64) + length.at(64) + reach.at(64)).upper();
    result *= max(power(nearest, point.power.at(64)), power(farthest, point.power.at(64)));
  }
  return result.upper();
}

}  // namespace steadyslide::enclosure
