#pragma once
// Pressures on N equal cells of the support as an exact state: with whole numbers n_j >= 0 that add up to S,
//
//   p_h = (P/h) n_j/S on cell j, h = (length of the support)/N,   so that int p_h = P exactly.
//
// Places are counted in cells from the left end of the support: y = (x - left)/h, cell j is ]j, j+1[.

#include <cstdint>
#include <span>
#include <vector>

#include "model/contact_problem.hpp"

namespace steadyslide::enclosure {

inline constexpr std::size_t most_cells = std::size_t{1} << 22;

class CellPressures {
 public:
  /// In any unit: only their ratios count. They are rounded to 2^-40 of the largest.
  /// Throws std::invalid_argument unless there are 1 to most_cells of them, finite, >= 0, not all of them 0.
  explicit CellPressures(std::span<const double> pressures);

  std::size_t size() const { return weights_.size(); }
  /// n_j, below 2^41: no sum of them exceeds 63 bits.
  const std::vector<std::int64_t>& weights() const { return weights_; }
  std::int64_t total() const { return before_.back(); }
  /// n_0 + ... + n_{j-1}.
  std::int64_t before(std::size_t j) const { return before_[j]; }
  /// S times the part of the load that lies left of y in [0, N].
  Rational load_before(const Rational& y) const;
  /// n_m - n_{m-1} at the node m = 0..N, the n beyond the support being 0.
  std::vector<std::int64_t> rises() const;

 private:
  std::vector<std::int64_t> weights_;
  std::vector<std::int64_t> before_;
};

}  // namespace steadyslide::enclosure
