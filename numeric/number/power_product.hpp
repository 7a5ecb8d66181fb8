#pragma once
// Products of powers at many points in one call, in double:
//
//   prod_j d_j^{p_j} = 2^S,   S = sum_j p_j log2 d_j,   |p_j| <= 1,   2^-1022 <= d_j < infinity,
//
// with one logarithm for each factor and one exponential for each point. The number of points computed together is the
// number of vector lanes of the processor.
//
// Logarithm: d = 2^k m, m in [1, 2[; next to m lies an a with log2 a = H + L, H a multiple of 2^-16, and
//   log2 d = (k + H) + (L + log2(1 + r)),   r = m/a - 1,   |r| < h = 2^-8.6,
// the last by five terms of its series and the sixth in terms of lower ones by Chebyshev's T6: error 2^-57.8. Without
// fused multiply-add, m - a is exact, with a the middle of m's 256th of [1, 2[, and L comes from a table. With it,
// r = fma(m, c, -1) is exact, c = 1/a, and c is chosen so that L is below 2^-57 and negligible. Rounding of the second
// bracket adds less than 2^-59.
//
// Sum: p = p' + p'', p' a multiple of 2^-16. The products p' (k + H) are multiples of 2^-32: sums of them are exact
// below 2^21. The rest, p'' (k + H) + p (L + log2(1 + r)), is below |p| 2^-6.4, and is added to the sum after every
// eighth factor.
//
// Error, in units in the last place of the result, of n factors, W = sum |p_j|, w the largest such sum over eight
// factors in a row: 1.7 from 2^S (2^-55 in its argument, three roundings of its polynomial's last two steps, up to sqrt
// 2 below 1), ln 2 2^53 times the above from the sums; altogether at most
//
//   1.7 + W/11 + n w/60,
//
// below 4 if W <= 8 and n w <= 90; the measured error is 1.2. Results below 2^-1022 are rounded once more.
//
// Results of different instruction sets differ in the last place. For one instruction set, a result depends neither on
// the compiler's options nor on the number of points.

#include <span>
#include <vector>

namespace steadyslide::numeric {

/// The factor (offset + d)^power, offset >= 0, |power| <= 1.
class PowerFactor {
 public:
  PowerFactor(double offset, double power);

  double offset;
  double power;
  double high;  ///< the power rounded to a multiple of 2^-16
  double low;   ///< power - high
};

enum class InstructionSet { baseline, avx2, avx512 };
/// Returns the instruction sets of this processor, the fastest last.
const std::vector<InstructionSet>& instruction_sets();

/// All sums are exact if the sum of |power| does not exceed this.
inline constexpr double largest_sum_of_powers = 900;

/// Sets values[i] to the product of `of_left` at d = left[i] and of `of_right` at d = right[i]. The last three spans
/// have the same length.
void power_products(std::span<const PowerFactor> of_left, std::span<const PowerFactor> of_right,
                    std::span<const double> left, std::span<const double> right, std::span<double> values,
                    InstructionSet set = instruction_sets().back());

}  // namespace steadyslide::numeric
