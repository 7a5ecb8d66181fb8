#pragma once
// The logarithmic potential of pressures on equal cells (cell_pressures.hpp), enclosed at every place y of the support,
// not only at nodes:
//
//   V(y) = sum_j n_j (1 + int_j^{j+1} log|y - y'| dy') = sum_m r_m l(y - m),   l(x) = x log|x|,   r_m = n_m - n_{m-1}
//
// (Abel's summation: sum r_m = 0, sum m r_m = -S. So the linear part -x of l adds -S, which the 1 cancels.)
//
// At the node i, V is a sum over cells with the numbers v_k = l(k+1) - l(k), where k is the number of cells in between.
// In cell i, y = i + z, each l(y - m) is its chord plus the difference from it (gap_part.hpp): chord - e_k(z) for a
// node k cells left of i, chord + e_k(1-z) for a node k cells right of i+1. For k >= 1, with a divided difference,
//   e_k(z) = z(1-z) w_k(z),   w_k(z) = f[0, 1, z],   f(z) = (k+z) log(k+z),   w_k'' = 2 f[0,1,z,z,z] = f''''/12 <= 1/(6 k^3),
// so the convex function w_k lies above its tangent at 1/2 by at most 1/(48 k^3). Altogether, with K = near,
//
//   V(i+z) = (1-z) V(i) + z V(i+1) - sum_{k<K} (r_{i-k} e_k(z) - r_{i+1+k} e_k(1-z))
//            - z(1-z) (A_i + B_i (z - 1/2) + [-R_i, R_i]),
//   A_i = sum_{k>=K} (r_{i-k} - r_{i+1+k}) a_k,   a_k = w_k(1/2) = 4 ((f(0)+f(1))/2 - f(1/2)),
//   B_i = sum_{k>=K} (r_{i-k} + r_{i+1+k}) b_k,   b_k = w_k'(1/2) = 4 (f(1) - f(0) - f'(1/2)),
//   R_i = sum_{k>=K} (|r_{i-k}| + |r_{i+1+k}|)/(48 k^3),
// and the mean over a cell is
//   mean_i = sum_j n_j (T(d+1) - 2 T(d) + T(d-1) - 1/2),   d = |i-j|,   T(x) = (x^2/2) log|x|.
// All of these are Toeplitz sums.

#include "enclosure/cells/cell_pressures.hpp"
#include "enclosure/number/ball.hpp"

namespace steadyslide::enclosure {

struct CellPotential {
  /// Computes everything with an absolute accuracy of about 2^-fraction S.
  CellPotential(const CellPressures& pressures, Bits fraction);

  std::vector<std::int64_t> rises;  ///< r_m
  std::vector<Ball> nodes;          ///< V at the nodes i = 0..N
  std::vector<Ball> means;          ///< mean of V over cell i
  std::vector<Ball> bend;           ///< A_i
  std::vector<Ball> skew;           ///< B_i
  std::vector<Ball> rest;           ///< R_i
};

}  // namespace steadyslide::enclosure
