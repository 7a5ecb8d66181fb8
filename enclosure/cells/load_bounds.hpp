#pragma once
// Bounds of the load left of the friction jumps c_k from a bound of the energy. In units of P and of cell lengths:
// d = p - p_h has no resultant, D(x) = int_left^x d, and (cell_bound.hpp)
//
//   beta + (1/2) sum_k [s_k] D(c_k)^2 <= E,   beta = b_0(d, d) = -(1/pi) int int d d log|x-x'| >= 0,   [s_k] >= 0.
//
// (i) By the inequality of Cauchy and Schwarz |sum a_k D(c_k)| <= sqrt(2 (E - beta) sum a_k^2/[s_k]).
//
// (ii) U(z) = -(1/pi) int d(x) log|z-x| dx has dU/dy = -d on the axis, from the upper half-plane, and decays. So
// int phi d = int grad Phi . grad U <= |grad Phi| sqrt(beta) for any Phi that is phi on the axis. Let phi be 1 on the
// support [L, R] left of c, 0 right of c + eps, monotone in between, and free outside. Since p >= 0,
//   D(c) = int_{x<c} p - int_{x<c} p_h <= int phi d + int_c^{c+eps} p_h <= q sqrt(beta) + m,   m = load of p_h on [c, c+eps].
// The least |grad Phi|^2 = q^2 is that of the rectangle onto which the half-plane maps with L, c, c + eps, R at its
// corners,
//   q^2 = K(k')/K(k) = agm(1, k')/agm(1, k),   k^2 = eps (R-L)/((c+eps-L)(R-c)),   k'^2 = (c-L)(R-c-eps)/((c+eps-L)(R-c));
// the real part of that map is monotone on [c, c+eps]. -D(c) has a similar bound with [c-eps, c]. Any eps is
// admissible.
//
// (i) decreases with beta and (ii) increases. So for any beta, the smaller of them is not above the larger of the two
// at any fixed beta; and (i) is not above its value at 0.

#include <array>

#include "enclosure/cells/cell_pressures.hpp"
#include "enclosure/number/ball.hpp"

namespace steadyslide::enclosure {

class LoadBounds {
 public:
  /// `energy` is E, finite and >= 0. s must nowhere decrease.
  LoadBounds(const ContactProblem& problem, const CellPressures& pressures, const Ball& energy);

  /// Returns an exact number that bounds |sum_k a_k D(c_k)|.
  Ball deviation(const std::vector<Rational>& a) const;
  /// Returns the values eps that were used in (ii), in cells: to the left and to the right of each jump.
  std::vector<std::array<Rational, 2>> reaches() const;

 private:
  /// The bound |D(c)| <= m + q sqrt(beta) for one side.
  struct Capacity {
    Rational reach;
    Ball load;
    Ball root;
  };
  Capacity best(const CellPressures& pressures, const Rational& c, bool right) const;

  Ball energy_;
  std::vector<Rational> rises_;  ///< [s_k]
  std::vector<std::array<Capacity, 2>> capacities_;
};

}  // namespace steadyslide::enclosure
