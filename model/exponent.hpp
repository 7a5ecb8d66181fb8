#pragma once
// The power of the distance to a singular point in the normal traction: offset + sum of times * arctan(slope) / pi,
// with a rational offset (a multiple of 1/4) and rational slopes s = gamma f. It is exact and has no precision.

#include <string>
#include <vector>

#include "model/rational.hpp"

namespace steadyslide {

class Exponent {
 public:
  /// One term times * arctan(slope) / pi. Stored with slope > 0 and times != 0.
  struct Angle {
    int times;
    Rational slope;
  };

  /// The largest |times|. A sum that would exceed it throws InvalidData.
  static constexpr int max_times = 10000;

  /// The same number as halves/2 + arctan(slope)/pi with -1 < slope <= 1: unique, and free of cancellation.
  struct Reduced {
    Integer halves;
    Rational slope;
    friend bool operator==(const Reduced&, const Reduced&) = default;
  };

  /// A number without angles. Throws InvalidData unless 4 * offset is an integer.
  explicit Exponent(const Rational& offset = 0);

  /// alpha = arctan(slope)/pi, the angle of the friction s = slope [Bal16, (4)].
  static Exponent angle(const Rational& slope);

  const Rational& offset() const { return offset_; }
  const std::vector<Angle>& angles() const { return angles_; }

  /// Exact for any slopes: multiplies Gaussian integers and counts the quadrants of the product's argument.
  Reduced reduced() const;
  /// Returns the exact sign: -1, 0 or +1.
  int sign() const;

  Exponent& operator+=(const Exponent& other);
  Exponent& operator-=(const Exponent& other) { return *this += -other; }
  Exponent operator-() const;
  friend Exponent operator+(Exponent a, const Exponent& b) { return a += b; }
  friend Exponent operator-(Exponent a, const Exponent& b) { return a -= b; }
  /// Compares the numbers, not how they are written: arctan(1/2) + arctan(1/3) equals pi/4.
  friend bool operator==(const Exponent& a, const Exponent& b) { return (a - b).sign() == 0; }

 private:
  void add(int times, const Rational& slope);

  Rational offset_;
  std::vector<Angle> angles_;
};

/// 1/2, the power at a free end without friction.
inline const Exponent half{Rational(1, 2)};

/// "-1/2 - arctan(3/35)/pi"
std::string to_string(const Exponent& exponent);

}  // namespace steadyslide
