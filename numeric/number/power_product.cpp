#include "numeric/number/power_product.hpp"

#include <cmath>
#include <limits>

#include "numeric/number/power_product_kernel.hpp"

namespace steadyslide::numeric {
namespace {

static_assert(std::numeric_limits<long double>::digits >= 64, "the tables' logarithms need more digits than a double");
static_assert(sizeof(PowerFactor) == 4 * sizeof(double));

/// Two doubles at a time in portable code; every x86-64 processor has such vectors.
struct BaselineLanes {
  static constexpr std::size_t count = 2;
  using Real [[gnu::vector_size(16)]] = double;
  using Bits [[gnu::vector_size(16)]] = std::uint64_t;
  struct Reduced {
    Real r, high, low;
  };

  static Real multiply_add(Real a, Real b, Real c) { return a * b + c; }

  static Reduced reduced(Bits bits, const LogarithmTable& table) {
    const std::size_t i = (bits[0] >> 44) & 255;
    const std::size_t j = (bits[1] >> 44) & 255;
    const Real inverse{table.rows[i].inverse, table.rows[j].inverse};
    const Real high{table.rows[i].high, table.rows[j].high};
    const Real low{table.low[i], table.low[j]};
    // m - a, where a is the middle of m's 256th of [1, 2[.
    const Real rest = (Real)((bits & (Bits{} + 0x00000fffffffffff)) | (Bits{} + 0x3ff0000000000000));
    const Real difference = rest - (Real{} + (1 + 0x1p-9));
    return {difference * inverse, exponent_and_part<BaselineLanes>(bits) + high, low};
  }
};

/// The table for the middles of the 256ths. H is stored without the 256ths that exponent_and_part() already counts.
LogarithmTable table_of_middles() {
  LogarithmTable table;
  for (int i = 0; i < 256; ++i) {
    const long double a = 1 + (i + 0.5L) / 256;
    const long double logarithm = std::log2(a);
    const auto high = static_cast<double>(std::round(logarithm * 0x1p16L) / 0x1p16L);
    table.rows[i] = {static_cast<double>(1 / a), high - i / 256.0};
    table.low[i] = static_cast<double>(logarithm - high);
  }
  return table;
}

/// The table with, of the 128 multiples H of 2^-16 around the logarithm of each middle, the one whose 2^-H is nearest
/// to a double.
LogarithmTable table_of_fortunate_inverses() {
  constexpr int reach = 64;
  long double step[2 * reach];
  for (int t = 0; t < 2 * reach; ++t) step[t] = std::exp2(-(t - reach) * 0x1p-16L);
  LogarithmTable table{};
  for (int i = 0; i < 256; ++i) {
    const double middle = std::round(std::log2(1 + (i + 0.5) / 256) * 0x1p16) / 0x1p16;
    const long double inverse = std::exp2(-static_cast<long double>(middle));
    long double least = 1;
    for (int t = 0; t < 2 * reach; ++t) {
      const long double exact = inverse * step[t];
      const auto rounded = static_cast<double>(exact);
      const long double error = std::abs(rounded - exact);
      if (error >= least) continue;
      least = error;
      table.rows[i] = {rounded, middle + (t - reach) * 0x1p-16 - i / 256.0};
    }
  }
  return table;
}

}  // namespace

PowerFactor::PowerFactor(double offset, double power)
    : offset(offset), power(power), high(std::round(power * 0x1p16) / 0x1p16), low(power - high) {}

const std::vector<InstructionSet>& instruction_sets() {
  static const std::vector<InstructionSet> sets = [] {
    std::vector<InstructionSet> result{InstructionSet::baseline};
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
      result.push_back(InstructionSet::avx2);
      if (__builtin_cpu_supports("avx512f")) result.push_back(InstructionSet::avx512);
    }
#endif
    return result;
  }();
  return sets;
}

void power_products(std::span<const PowerFactor> of_left, std::span<const PowerFactor> of_right,
                    std::span<const double> left, std::span<const double> right, std::span<double> values,
                    InstructionSet set) {
  const auto numbers = [](std::span<const PowerFactor> factors) {
    return factors.empty() ? nullptr : &factors[0].offset;
  };
  const PowerProducts task{numbers(of_left), of_left.size(), numbers(of_right), of_right.size(),
                           left.data(),      right.data(),   values.data(),     values.size()};
  if (set == InstructionSet::baseline) {
    static const LogarithmTable table = table_of_middles();
    return PowerProductKernel<BaselineLanes>(task, table).run();
  }
#ifdef __x86_64__
  static const LogarithmTable table = table_of_fortunate_inverses();
  set == InstructionSet::avx2 ? power_products_avx2(task, table) : power_products_avx512(task, table);
#endif
}

}  // namespace steadyslide::numeric
