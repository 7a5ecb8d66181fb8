#pragma once
// Reference values of the tests of exact tractions.

#include <boost/multiprecision/gmp.hpp>

#include "support/problems.hpp"

namespace steadyslide::testing {

/// 1/pi, mpmath at 80 digits.
inline const Rational one_over_pi = 0.31830988618379067153776752674502872406891929148091289749533468811779358_r;

/// Agreement to `digits` digits.
inline bool near(const Rational& a, const Rational& b, int digits) {
  const Integer scale = boost::multiprecision::pow(Integer(10), static_cast<unsigned>(digits));
  return abs(a - b) * scale <= abs(b) * 10;
}

/// A multiple of 1/60 from `low` up to, but not including, `high`.
inline Rational sixtieths(int low, int high) { return Rational(uniform(low, high - 1), 60); }

struct RandomFriction {
  std::vector<Rational> jumps;  ///< up to four in ]-1, 1[
  std::vector<Rational> s;      ///< up to 3
};

inline RandomFriction random_friction() {
  RandomFriction result;
  for (Rational c = sixtieths(-59, 0); result.jumps.size() < 4 && c < 1; c += sixtieths(1, 60)) {
    result.jumps.push_back(c);
  }
  for (std::size_t k = 0; k <= result.jumps.size(); ++k) result.s.push_back(sixtieths(0, 180));
  return result;
}

}  // namespace steadyslide::testing
