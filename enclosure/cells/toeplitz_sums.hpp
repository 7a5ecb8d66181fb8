#pragma once
// Enclosed sums  r_i = sum_j w_j k_{i-j},  i = 0..count-1,  of whole numbers w and enclosed numbers k.
//
// Each k becomes a whole number K of units 2^-fraction, and sum w_j K_{i-j} is a coefficient of a product of two
// polynomials with whole coefficients (FLINT), exact. If |k - 2^-fraction K| <= e for every k, then
//   |r_i - 2^-fraction sum w_j K_{i-j}| <= e sum |w_j|.

#include <cstdint>
#include <vector>

#include "enclosure/number/ball.hpp"

namespace steadyslide::enclosure {

/// `kernel`: k_d for d = -(weights.size() - 1) up to count - 1, in this order. Throws std::invalid_argument where their
/// number is another or one of them is not finite.
std::vector<Ball> toeplitz_sums(const std::vector<std::int64_t>& weights, const std::vector<Ball>& kernel,
                                std::size_t count, Bits fraction);

}  // namespace steadyslide::enclosure
