#pragma once
// Sources c_i with weights w_i on a line, grouped in cells. A cell with centre c and half-width h stores the moments
//
//   m_k = sum_i w_i u_i^k,   u_i = (c_i - c)/h in [-1, 1],   k < 34,
//
// so that sum_i w_i f(c_i) = sum_k a_k m_k for any function f = sum_k a_k u^k that is smooth on the cell.

#include <array>
#include <vector>

#include "numeric/hierarchical/panel_tree.hpp"

namespace steadyslide::numeric::hierarchical {

struct Source {
  std::size_t panel;
  double from_left;  ///< distances from the ends of its panel
  double from_right;
};

class CellMoments {
 public:
  static constexpr std::size_t terms = 34;
  using Series = std::array<double, terms>;

  /// Takes sources from left to right; weights[s][i] is the weight of source i in sum number s.
  CellMoments(const std::vector<double>& lengths, const std::vector<Source>& sources,
              const std::vector<std::vector<double>>& weights);

  const PanelTree& tree() const { return tree_; }
  std::size_t sums() const { return stride_ / terms; }
  /// Returns m_0, m_1, ...
  const double* of(std::size_t cell, std::size_t sum) const { return &moments_[cell * stride_ + sum * terms]; }
  /// Returns sum_k a_k m_k, k < count.
  double weighted(std::size_t cell, std::size_t sum, const Series& a, std::size_t count = terms) const;

 private:
  void gather(const std::vector<Source>& sources, const std::vector<std::vector<double>>& weights);
  void shift_to_parent(std::size_t cell);

  std::size_t stride_;  ///< number of moments of a cell
  PanelTree tree_;
  std::vector<double> moments_;  ///< for each cell and each sum
};

}  // namespace steadyslide::numeric::hierarchical
