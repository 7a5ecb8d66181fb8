#pragma once
// Sums over sources c_i on a line at many places x, in O(N) for N sources and panels:
//
//   Kernel::logarithm: sum_i w_i log|x - c_i|,   Kernel::cauchy: sum_i w_i/(c_i - x),   Kernel::distance: sum_i w_i/|c_i - x|.
//
// With the moments m_k of a cell with centre c and half-width h (cell_moments.hpp), at the distance D = |x - c|,
// r = +-h/D with the sign of x - c, they are
//
//   m_0 log D - sum_k m_k r^k/k,      -+(1/D) sum_k m_k r^k,      (1/D) sum_k m_k r^k.
//
// The sum of far cells is computed at the 22 Chebyshev nodes of a cell, passed down from cell to cell, and interpolated
// on each panel. The caller adds the near panels, because it knows their sources better (panel_tree.hpp).
//
// Error. Far means a distance of at least the extent 2h of the sources and the length of the target: |r| <= 1/3, so
// that the series' rest is below 3^-34/34 < 2e-18 of sum |w_i| (logarithm) or 1.5 3^-34 < 1e-16 of sum |w_i|/D
// (Cauchy); and the nearest source is outside the Bernstein ellipse rho = 3 + sqrt 8 of the target, so that
// interpolation errs by
// 4 rho^-22/22/(1 - 1/rho) < 4e-18 or, relative to the largest value on it, 4 rho^-22 < 6e-17. The rest is rounding. A
// value v in one cell has the error epsilon v times the Lebesgue constant of the nodes, 2.9. Passed down, it remains a
// polynomial of the same degree, so the errors of several levels add and do not grow. The two constants below estimate
// this error; tests compare with sums in more digits.
//
// In double. Places must not be nearer to a source than the smallest normal number.

#include <vector>

#include "numeric/hierarchical/cell_moments.hpp"

namespace steadyslide::numeric::hierarchical {

/// Estimates of the rounding error of a sum over far sources, in units of epsilon sum |w_i| max(1, |log d|), or of
/// epsilon sum |w_i|/d. The errors of hundreds of panels that are graded, or of arbitrary lengths, are up to 12 and 24
/// units; of equal panels 2 and 6 units.
inline constexpr double logarithm_rounding = 16;
inline constexpr double cauchy_rounding = 32;

/// Fewer panels than this are summed one by one. This is not slower and keeps the rounding as it was.
inline constexpr std::size_t fewest_panels = 128;

class LineSum {
 public:
  enum class Kernel { logarithm, cauchy, distance };

  /// Takes sources from left to right; weights[s][i] is the weight of source i in sum number s.
  LineSum(std::vector<Kernel> kernels, const std::vector<double>& lengths, const std::vector<Source>& sources,
          const std::vector<std::vector<double>>& weights);

  std::size_t sums() const { return kernels_.size(); }
  const PanelTree& tree() const { return moments_.tree(); }
  const std::vector<PanelTree::Near>& near_to(std::size_t panel) const { return tree().near_to(panel); }

  /// Returns the sum over all sources that are neither in panel k nor near it, at a place of the panel or at its ends.
  double far(std::size_t sum, std::size_t k, double from_left, double from_right) const;
  /// Returns the sum over the sources of one cell. They are on the given side of the place; `distance` is that of the
  /// nearest.
  double of_cell(std::size_t sum, std::size_t cell, Side side, double distance) const;
  /// Returns sum_i w_i log(|x - c_i|/|e - c_i|) over a cell's sources, for any kernel. e is at `distance` and x at
  /// `distance` + `step` > 0; both are far.
  double logarithmic_rise(std::size_t sum, std::size_t cell, Side side, double distance, double step) const;

 private:
  void hand_down(std::size_t cell, const double* parent);
  void add_far(std::size_t cell, double* values) const;

  std::vector<Kernel> kernels_;
  CellMoments moments_;
  std::vector<double> fields_;  ///< for each panel and each sum: coefficients of Chebyshev's polynomials
};

}  // namespace steadyslide::numeric::hierarchical
