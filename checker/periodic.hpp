#pragma once
// Periodic contact on one zone in each period L, from a certificate of kind "periodic". With xi = (x - origin)/L,
//
//   A t = p.v. int t(xi') cot(pi (xi'-xi)) dxi' + s t + S = g,   S = -int s t dxi,
//   g = sum_n (2 pi n/(L c)) (sin_n cos(2 pi n xi) - cos_n sin(2 pi n xi)),   int t dxi = -P/L,
//
// over one period; cos_n and sin_n are the amplitudes of the profile. S keeps the displacement periodic. Let
// Y(z) = prod_j |sin pi (z - e_j)|^(p_j) with the powers of checker/contact.hpp, m = sum p_j, and a real polynomial
// T = sum_k tau_k e^(-i pi k xi) + conjugate, k = m mod 2, ..., 2N - m, of which tau_0 is real and stands once. Then
//
//   t = -cos(pi alpha) |Y| T in the contact,   u'/c = g + phase |Y| T to the right of it,
//
// solves the equation if and only if phase Y T + g, in powers of q = e^(i pi z) at z = +i oo, has no terms q^(-2n) and
// its constant term is S - i P/L: the function phase Y T + g - S in the upper half-plane and its conjugate in the lower
// one then differ from int t cot(pi (xi'-z)) dxi' by an entire bounded function, and this is 0. phase = 1 if the right
// end is an edge, -1 if it is free, (s - i) cos(pi alpha) of the last arc if there is no gap. At +i oo
//
//   sin(pi (z - e))^p = (i/2)^p e^(i pi p e) q^-p (1 - q^2 e^(-2 pi i e))^p.
//
// The unknowns are the free ends and the tau_k. The pressure is positive if T > 0. From a free end outwards the gap grows
// with the slope |Y| T, T continued from that end.

#include <array>
#include <vector>

#include "checker/ball.hpp"
#include "checker/problem.hpp"

namespace steadyslide::checker {

class Reader;

struct Periodic {
  Problem problem;
  Rational origin;
  std::array<Rational, 2> ends;    ///< in x
  std::array<bool, 2> free;        ///< false: an edge, or no gap
  std::vector<Rational> traction;  ///< tau_0 for even m, then the real and imaginary parts of the others
  Rational radius;                 ///< of the box: in periods for ends, in parts of the largest tau_k for tau_k
  std::array<Rational, 2> effective_friction;
  std::array<Rational, 2> centre_of_pressure;

  static Periodic of_certificate(const Reader& at);
  /// True if the indenter has no edges.
  bool is_whole() const { return problem.pieces.back().to - problem.left == problem.period; }
  bool has_gap() const { return !is_whole() || free[0]; }
  int m() const { return has_gap() ? int(free[0]) + int(free[1]) - 1 : 0; }
  int harmonics() const { return problem.harmonics.empty() ? 0 : problem.harmonics.rbegin()->first; }
};

struct PeriodicProof {
  double contraction = 0;
  std::size_t in_contact = 0;  ///< intervals on which T > 0 was decided
  std::size_t in_gap = 0;      ///< intervals on which the gap was decided
};

/// Proves that the box has a solution, and that it has the claimed friction and centre. Throws Unproved.
PeriodicProof prove_periodic(const Periodic& claim);

}  // namespace steadyslide::checker
