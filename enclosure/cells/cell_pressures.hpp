#pragma once
// Pressures on N equal cells of the support as an exact state: with integers n_j >= 0 whose sum is S,
//
//   p_h = (P/h) n_j/S on cell j, h = (length of the support)/N,   so that int p_h = P exactly.
//
// Places are measured in cells from the left end of the support: y = (x - left)/h, cell j is ]j, j+1[.

#include <cstdint>
#include <span>
#include <vector>

#include "model/contact_problem.hpp"

namespace steadyslide::enclosure {

inline constexpr std::size_t most_cells = std::size_t{1} << 22;

class CellPressures {
 public:
  /// Takes pressures in any unit, because only their ratios matter. They are rounded to 2^-40 of the largest.
  /// Throws std::invalid_argument unless there are 1 to most_cells of them, finite, >= 0, not all of them 0.
  explicit CellPressures(std::span<const double> pressures);

  std::size_t size() const { return weights_.size(); }
  /// Returns n_j. They are below 2^41, so no sum of them exceeds 63 bits.
  const std::vector<std::int64_t>& weights() const { return weights_; }
  std::int64_t total() const { return before_.back(); }
  /// Returns n_0 + ... + n_{j-1}.
  std::int64_t before(std::size_t j) const { return before_[j]; }
  /// Returns S times the fraction of the load left of y in [0, N].
  Rational load_before(const Rational& y) const;
  /// Returns n_m - n_{m-1} at the nodes m = 0..N, with n = 0 beyond the support.
  std::vector<std::int64_t> rises() const;

 private:
  std::vector<std::int64_t> weights_;
  std::vector<std::int64_t> before_;
};

}  // namespace steadyslide::enclosure
