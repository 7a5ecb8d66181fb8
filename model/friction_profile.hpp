#pragma once
// The friction coefficient f(x) under the indenter: a step function, left to right in the user's x. [Bal16, section 4]

#include <vector>

#include "model/direction.hpp"
#include "model/rational.hpp"

namespace steadyslide {

class FrictionProfile {
 public:
  /// Takes values f_0..f_m >= 0 and jumps c_1 < ... < c_m; a jump of height zero is allowed. Throws InvalidData
  /// otherwise.
  explicit FrictionProfile(std::vector<Rational> values, std::vector<Rational> jumps = {});

  const std::vector<Rational>& values() const { return values_; }
  const std::vector<Rational>& jumps() const { return jumps_; }
  /// Returns f at x; at a jump, the limit from that side.
  const Rational& at(const Rational& x, Side side) const { return values_[piece(x, side)]; }
  /// Returns the index of the piece that contains x; at a jump, of the piece on that side.
  std::size_t piece(const Rational& x, Side side) const;

  /// Returns the profile in the coordinate y = scale x + shift, scale != 0. A negative scale exchanges left and right.
  FrictionProfile moved(const Rational& scale, const Rational& shift) const;
  /// Returns the profile with one more jump at c: f is larger by `height` between c and the next jump. Throws
  /// InvalidData if there is already a jump at c.
  FrictionProfile with_jump(const Rational& c, const Rational& height) const;
  friend bool operator==(const FrictionProfile&, const FrictionProfile&) = default;

 private:
  std::vector<Rational> values_;
  std::vector<Rational> jumps_;
};

}  // namespace steadyslide
