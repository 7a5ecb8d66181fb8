#pragma once
// The gap under pressures on cells, up to a constant, on a part of one cell on which profile and friction are one
// polynomial each; z in [0, 1] over the cell:
//
//   H(z) = q(z) + sum_{k < near} (a_k e_k(z) - b_k e_k(1-z)) + [-rest, rest],
//   e_k(z) = (1-z) f_k(0) + z f_k(1) - f_k(z),   f_k(z) = (k+z) log(k+z);   e_0(z) = -z log z.
//
// How far H may dip below its chord over [z0, z1], w = z1 - z0. A function g with g'' <= M dips by at most M w^2/8. Here
// e_k'' = -1/(k+z), so that a e_k(z) adds -a/(k+z1) to M for a > 0 and |a|/(k+z0) for a < 0; for a < 0 and k + z0 = 0, where
// this is infinite, |a| e_0 itself lies above its chord by at most max |a| z log(z1/z) = |a| z1/e. The same with -b, from
// the right.

#include <array>

#include "enclosure/number/ball_polynomial.hpp"

namespace steadyslide::enclosure {

/// So many nodes on either side of a cell have their logarithms, those further away a polynomial.
inline constexpr std::size_t near = 3;

/// e_k, those at z = j/64 made once.
class NearLogarithms {
 public:
  explicit NearLogarithms(Bits bits);
  /// At a double in [0, 1], exactly.
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
  // Where it holds: [from, to], rounded outwards to multiples of 2^-20.
  double from = 0;
  double to = 1;

  /// H without its rest. z: a multiple of 2^-52.
  Ball value(double z, const NearLogarithms& e) const;
  /// What this may lie below the lesser of value(z0), value(z1) in [z0, z1], >= 0.
  Ball dip(double z0, double z1) const;
};

}  // namespace steadyslide::enclosure
