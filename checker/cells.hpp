#pragma once
// Pressures on N equal cells of the support as an exact state, and a bound of their distance from the solution. Only if
// s never decreases towards +x, the profile has no steps and the indenter cannot tilt (theorem 1 of [Bal16]): then
// there is exactly one solution p.
//
// Places are y = (x - left)/h, cell i is ]i, i+1[, and p_h = (P/h) n_i/S on it, S = sum n_i. The gap under p_h is, in
// units of c P and up to a constant,
//
//   H(y) = psi/(c P) - V(y)/(pi S) + F(y)/S,   V(y) = sum_m r_m l(y - m),   r_m = n_m - n_{m-1},   l(x) = x log|x|,
//   F(y) = int_0^y s n dy'.
//
// With E = <H, p_h>/P - min H, and d = p - p_h and D(x) = int_left^x d in units of P, the energy identity gives
//
//   beta + (1/2) sum_k [s_k] D(c_k)^2 <= E,   beta = -(1/pi) int int d d log|x - x'| >= 0,
//
// so |sum a_k D(c_k)| <= sqrt(2 (E - beta) sum a_k^2/[s_k]). For any eps, with m the fraction of p_h's load on [c,
// c+eps],
//
//   D(c) <= m + sqrt(beta K(1-M)/K(M)),   M = eps N/((c + eps)(N - c)),
//
// with c and eps in cells, and K the complete elliptic integral of the parameter M: a function that is 1 on the support
// left of c and 0 right of c + eps has at least that energy in the half-plane. -D(c) has a similar bound from the other
// side.
//
// The checker does not compute min H. It decides H >= <H, p_h>/P - E at every place for the claimed E. Around the
// middle of a cell, y = i + 1/2 + t, nodes within 3 keep their logarithms; all others are replaced by their Taylor
// polynomial in t of degree 8,
//   l(d + t) = d log|d| + (log|d| + 1) t + sum_{p=2}^8 (-t)^p/(p (p-1) d^(p-1)) + rest,   |rest| <= 2^-9/(72 |d|^8 (1 - 1/(2|d|))),
// whose coefficients are sums over all nodes, computed as products of polynomials with integer coefficients.

#include <array>
#include <cstdint>
#include <vector>

#include "checker/ball.hpp"
#include "checker/problem.hpp"

namespace steadyslide::checker {

class Reader;

/// The claim of a certificate of kind "cells".
struct Cells {
  Problem problem;
  std::vector<std::int64_t> weights;             ///< n_i
  Rational energy;                               ///< E
  std::vector<std::array<Rational, 2>> reaches;  ///< eps to the left and to the right of each jump
  std::vector<std::array<Rational, 2>> load_share;
  std::array<Rational, 2> effective_friction;

  static Cells of_certificate(const Reader& at);
};

/// Returns the number of intervals on which H was decided to be high enough. Throws Unproved.
std::size_t prove_cells(const Cells& cells);

}  // namespace steadyslide::checker
