#pragma once
// Sums over sources c_i on a line at many places x, in O(N) for N sources and panels:
//
//   Kernel::logarithm: sum_i w_i log|x - c_i|,   Kernel::cauchy: sum_i w_i/(c_i - x),   Kernel::distance: sum_i w_i/|c_i - x|.
//
// With the moments m_k of a cell with centre c and half-width h (cell_moments.hpp), at the distance D = |x - c|, r = +-h/D
// with the sign of x - c, they are
//
//   m_0 log D - sum_k m_k r^k/k,      -+(1/D) sum_k m_k r^k,      (1/D) sum_k m_k r^k.
//
// What far cells do to a cell is known at its 22 Chebyshev nodes, handed down from cell to cell, and interpolated on each
// panel. Panels that are near are left to the caller, who knows their sources better (panel_tree.hpp).
//
// Error. Far means a distance of at least the extent 2h of the sources and the length of the target: |r| <= 1/3, so that
// the series' rest is below 3^-34/34 < 2e-18 of sum |w_i| (logarithm) or 1.5 3^-34 < 1e-16 of sum |w_i|/D (Cauchy); and the
// nearest source is outside the Bernstein ellipse rho = 3 + sqrt 8 of the target, so that interpolation errs by
// 4 rho^-22/22/(1 - 1/rho) < 4e-18 or, relative to the largest value on it, 4 rho^-22 < 6e-17. The rest is rounding: what
// has the size v in one cell is wrong by epsilon v times the Lebesgue constant of the nodes, 2.9, and being handed
// down it stays a polynomial of the same degree, so that errors of several levels add up and do not grow. The two
// constants below estimate it; tests compare with sums in more digits.
//
// In double. Not for places nearer than the smallest number to a source.

#include <vector>

#include "numeric/hierarchical/cell_moments.hpp"

namespace steadyslide::numeric::hierarchical {

/// Of a sum over far sources, in units of epsilon sum |w_i| max(1, |log d|), or of epsilon sum |w_i|/d. Hundreds of panels
/// that are graded, or of any lengths, err by up to 12 and 24 of them, even ones by 2 and 6.
inline constexpr double logarithm_rounding = 16;
inline constexpr double cauchy_rounding = 32;

/// Fewer panels than this are summed one by one: that costs no more, and rounds as it always has.
inline constexpr std::size_t fewest_panels = 128;

class LineSum {
 public:
  enum class Kernel { logarithm, cauchy, distance };

  /// Sources from left to right; weights[s][i] is that of source i in sum number s.
  LineSum(std::vector<Kernel> kernels, const std::vector<double>& lengths, const std::vector<Source>& sources,
          const std::vector<std::vector<double>>& weights);

  std::size_t sums() const { return kernels_.size(); }
  const PanelTree& tree() const { return moments_.tree(); }
  const std::vector<PanelTree::Near>& near_to(std::size_t panel) const { return tree().near_to(panel); }

  /// Of all sources that are neither in panel k nor near to it, at a place of the panel, its ends included.
  double far(std::size_t sum, std::size_t k, double from_left, double from_right) const;
  /// The sources of one cell at the distance given beyond the nearest of them; they are on that side of the place.
  double of_cell(std::size_t sum, std::size_t cell, Side side, double distance) const;
  /// sum_i w_i log(|x - c_i|/|e - c_i|) over a cell's sources, whatever the kernel is: from a place e at `distance` to one
  /// at `distance` + `step` > 0, both far.
  double logarithmic_rise(std::size_t sum, std::size_t cell, Side side, double distance, double step) const;

 private:
  void hand_down(std::size_t cell, const double* parent);
  void add_far(std::size_t cell, double* values) const;

  std::vector<Kernel> kernels_;
  CellMoments moments_;
  std::vector<double> fields_;  ///< of each panel, of each sum: coefficients of Chebyshev's polynomials
};

}  // namespace steadyslide::numeric::hierarchical
