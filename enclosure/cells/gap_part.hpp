#pragma once
// The gap under pressures on cells, up to a constant, on a part of one cell with one polynomial for the profile and one
// for the friction; z in [0, 1] over the cell:
//
//   H(z) = q(z) + sum_{k < near} (a_k e_k(z) - b_k e_k(1-z)) + [-rest, rest],
//   e_k(z) = (1-z) f_k(0) + z f_k(1) - f_k(z),   f_k(z) = (k+z) log(k+z);   e_0(z) = -z log z.
//
// The dip is the largest distance of H below its chord over [z0, z1], w = z1 - z0. A function g with g'' <= M dips by
// at most M w^2/8. Here e_k'' = -1/(k+z), so a e_k(z) adds -a/(k+z1) to M for a > 0 and |a|/(k+z0) for a < 0. For a < 0
// and k + z0 = 0 this is infinite; then |a| e_0 lies above its chord by at most max |a| z log(z1/z) = |a| z1/e. The
// same holds with -b, from the right.

#include <array>

#include "enclosure/number/ball_polynomial.hpp"

namespace steadyslide::enclosure {

/// The number of nodes on each side of a cell that have logarithms. Nodes further away are represented by a polynomial.
inline constexpr std::size_t near = 3;

/// The functions e_k, with stored values at z = j/64.
class NearLogarithms {
 public:
  explicit NearLogarithms(Bits bits);
  /// Returns e_k at z in [0, 1], which is taken as exact.
  Ball operator()(std::size_t k, double z) const;

 private:
  Ball made(std::size_t k, const Ball& z) const;

  Bits bits_;
  std::array<std::vector<Ball>, near> tables_;
};

struct GapPart {
  BallPolynomial q;
  std::array<Ball, near> a;
  std::array<Ball, near> b;
  Ball rest;  ///< >= 0
  // The part is [from, to], rounded outwards to multiples of 2^-20.
  double from = 0;
  double to = 1;

  /// Returns H without its rest. z is a multiple of 2^-52.
  Ball value(double z, const NearLogarithms& e) const;
  /// Returns a bound >= 0 of the distance of this below the smaller of value(z0), value(z1), in [z0, z1].
  Ball dip(double z0, double z1) const;
};

}  // namespace steadyslide::enclosure
