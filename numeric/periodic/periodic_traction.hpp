#pragma once
// Periodic contact on one zone [e_0, e_n] in each period L, with s constant between its jumps and a trigonometric slope
//
//   A_L t = (1/L) PV int t(x') cot(pi (x'-x)/L) dx' + s t + S = g,   S = -(1/L) int s t dx',
//   g = sum_{n=1}^N A_n cos(2 pi n x/L) + B_n sin(2 pi n x/L).
//
// S keeps u periodic. Phi(z) = (1/L) int t cot(pi (x'-z)/L) dx' has the limits H_L t + i t on the line, -i P/L at +i oo,
// and Phi + S - g is -(s - i) t on the contact and real beside it. So with Y of periodic_fundamental_solution.hpp
//
//   Phi + S - g = +-Y T (+ edge, - free end on the right),   t = -cos(pi alpha) |Y| T,   u'/c - g = +-|Y| T in the gap,
//
// x from e_n to e_0 + L there, with T = sum_k tau_k e^{-i pi k x/L} + conjugate, k = 2N - m, 2N - m - 2, ... >= 0, as
// nothing else grows like g. In q = e^{i pi z/L} the condition at +i oo says:
//
//   coefficient of q^{-2n} of +-Y T + g is 0 for n = N, ..., 1;   of q^0: S - i P/L.
//
// Its first N equations give all tau_k but the last one (m = 0, -1). S needs an integral only if the friction jumps.
//
// If the whole circle is in contact, the e_j are its friction jumps, m = 0, and (s - i) cos(pi alpha), s left of e_0,
// stands in place of +-1. Then the real part of the last equation holds for every load.
// Derived for this project; compare [Bal16, (4), (5)-(7)] for L = oo. docs/theory.md, "Periodic contact".

#include <vector>

#include "numeric/cauchy/fundamental_solution.hpp"
#include "numeric/periodic/periodic_fundamental_solution.hpp"
#include "numeric/quadrature/density.hpp"

namespace steadyslide::numeric {

template <Real R>
struct PeriodicTraction {
  PeriodicFundamentalSolution<R> weight;  ///< the last arc is the gap, if there is one
  std::vector<R> cosines;                 ///< cos(pi alpha) on the arcs of the contact
  Complex<R> phase;                       ///< the factor of Y T: 1 if the right end is an edge, -1 if it is free
  int parity;                             ///< of the k in T: that of m
  std::vector<Complex<R>> tau{};          ///< for k = parity, parity + 2, ...

  std::size_t gap() const { return cosines.size(); }
  bool has_gap() const { return weight.size() > cosines.size(); }
  /// Returns T(x), and as second member the sum of the sizes of its terms.
  std::pair<R, R> polynomial(const R& x) const;
  /// Returns t on arc k of the contact, or (u'/c - g) in the gap, without the powers as in modulus().
  R value(std::size_t k, const R& from_left, const R& from_right, bool without_left = false,
          bool without_right = false) const;
  /// Returns value() for the quadrature routes, on the part of the arc that begins at the distance `from_left` from its
  /// left end and ends at `from_right` from its right end. At 0 it has the power of that end.
  PanelDensity<R> density(std::size_t k, const R& from_left = R(0), const R& from_right = R(0)) const;
};

/// The data of a zone.
template <Real R>
struct PeriodicZone {
  PeriodicTraction<R> traction;  ///< without tau
  std::vector<R> s;              ///< on the arcs of the contact
  std::vector<Complex<R>> g;     ///< A_n + i B_n, n = 1, 2, ...
  R load;                        ///< P, used unless it follows from the ends
  int m;                         ///< the sum of the powers: free ends - 1, or 0 without a gap
};

/// The traction for given ends.
template <Real R>
struct PeriodicState {
  PeriodicTraction<R> traction;
  R load;     ///< -int t
  R closure;  ///< the real part of the condition at +i oo, 0 for a solution; with an edge always 0
};

template <Real R>
PeriodicState<R> periodic_state(PeriodicZone<R> zone);

}  // namespace steadyslide::numeric
