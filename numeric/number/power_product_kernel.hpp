#pragma once
// The products of power_product.hpp on the vector lanes of one instruction set. `Lanes` provides:
//
//   count, Real, Bits        number of lanes, vectors of doubles, and of their bits
//   multiply_add(a, b, c)    a b + c, fused or not
//   reduced(bits, table)     {r, H, L} of numbers with these bits
//
// Files compiled for an instruction set must not include inline functions of the standard library: the linker may keep
// the copy of an inline function from any of these files, and then all processors would use it.

#include <cstddef>
#include <cstdint>

namespace steadyslide::numeric {

/// The numbers a for the 256 parts of [1, 2[, with log2 a = high + low.
struct LogarithmTable {
  struct Row {
    double inverse;
    double high;
  };
  alignas(64) Row rows[256];
  double low[256];
};

/// The arguments of a call through a function pointer. They contain no vectors.
struct PowerProducts {
  const double* of_left;  ///< offset, power, high, low of each factor
  std::size_t left_factors;
  const double* of_right;
  std::size_t right_factors;
  const double* left;
  const double* right;
  double* values;
  std::size_t points;
};

template <class Lanes>
class PowerProductKernel {
  using Real = typename Lanes::Real;
  using Bits = typename Lanes::Bits;
  static constexpr std::size_t lanes = Lanes::count;

 public:
  PowerProductKernel(const PowerProducts& task, const LogarithmTable& table) : task_(task), table_(table) {}

  void run() const {
    // Process two vectors together, which share the data of a factor.
    std::size_t i = 0;
    for (; i + 2 * lanes <= task_.points; i += 2 * lanes) block<2>(task_.left + i, task_.right + i, task_.values + i);
    for (; i < task_.points; i += lanes) {
      double left[lanes];
      double right[lanes];
      double values[lanes];
      for (std::size_t l = 0; l < lanes; ++l) {
        const std::size_t at = i + l < task_.points ? i + l : task_.points - 1;
        left[l] = task_.left[at];
        right[l] = task_.right[at];
      }
      block<1>(left, right, values);
      for (std::size_t l = 0; l < lanes && i + l < task_.points; ++l) task_.values[i + l] = values[l];
    }
  }

 private:
  struct Sum {
    Real high{};
    Real low{};
  };

  static Real all(double x) { return Real{} + x; }
  static Bits all_bits(std::uint64_t x) { return Bits{} + x; }
  static Real multiply_add(Real a, Real b, Real c) { return Lanes::multiply_add(a, b, c); }
  static Real load(const double* from) {
    Real result;
    __builtin_memcpy(&result, from, sizeof result);
    return result;
  }

  template <std::size_t vectors>
  void block(const double* left, const double* right, double* values) const {
    Sum sums[vectors];
    add<vectors>(sums, task_.of_left, task_.left_factors, left);
    add<vectors>(sums, task_.of_right, task_.right_factors, right);
    for (std::size_t v = 0; v < vectors; ++v) {
      const Real value = power_of_two(sums[v]);
      __builtin_memcpy(values + v * lanes, &value, sizeof value);
    }
  }

  template <std::size_t vectors>
  void add(Sum (&sums)[vectors], const double* factor, std::size_t count, const double* distances) const {
    for (std::size_t done = 0; done < count;) {
      const std::size_t until = count - done > 8 ? done + 8 : count;
      for (; done < until; ++done, factor += 4) {
        for (std::size_t v = 0; v < vectors; ++v) add(sums[v], load(distances + v * lanes) + all(factor[0]), factor);
      }
      for (Sum& sum : sums) carry(sum);
    }
  }

  void add(Sum& sum, Real d, const double* factor) const {
    constexpr double e = 1.44269504088896340736;  // log2(e)
    constexpr double h2 = 6.3e-6;                 // h^2
    const auto [r, high, low] = Lanes::reduced((Bits)d, table_);
    Real series = multiply_add(all(e / 5), r, all(-e / 4 - e / 4 * h2));
    series = multiply_add(series, r, all(e / 3));
    series = multiply_add(series, r, all(-e / 2 + e * 3 / 32 * h2 * h2));
    series = multiply_add(series, r, all(e));
    const Real rest = multiply_add(series, r, low);
    sum.high = multiply_add(all(factor[2]), high, sum.high);  // exact
    sum.low = multiply_add(all(factor[3]), high, sum.low);
    sum.low = multiply_add(all(factor[1]), rest, sum.low);
  }

  static void carry(Sum& sum) {
    const Real shift = all(0x1.8p20);  // numbers near it are multiples of 2^-32
    const Real carried = (sum.low + shift) - shift;
    sum.high += carried;
    sum.low -= carried;
  }

  static Real power_of_two(const Sum& sum) {
    const Real shift = all(0x1.8p52);  // numbers near it are integers
    Real exponent = sum.high + sum.low;
    exponent = exponent < all(-2200) ? all(-2200) : exponent;
    exponent = exponent > all(2200) ? all(2200) : exponent;
    const Real whole = (exponent + shift) - shift;
    const Real f = (sum.high - whole) + sum.low;
    // exp(f log 2), |f| <= 1/2, without the powers from the 14th on: 2^-57.
    constexpr double l = 0.693147180559945309417;  // log(2)
    constexpr int degree = 13;
    double c[degree + 1] = {1};
    for (int k = 1; k <= degree; ++k) c[k] = c[k - 1] * l / k;
    Real value = all(c[degree]);
    for (int k = degree; k-- > 0;) value = multiply_add(value, f, all(c[k]));
    // Multiply in two steps: 2^whole alone may be out of range although the product is not.
    const Real half = (whole * all(0.5) + shift) - shift;
    const Real biased = shift + all(1023);
    const Real scale = (Real)((Bits)(half + biased) << 52);
    const Real rest = (Real)((Bits)((whole - half) + biased) << 52);
    return value * scale * rest;
  }

  const PowerProducts& task_;
  const LogarithmTable& table_;
};

/// Returns the bits of m in [1, 2[, and k + the part of [1, 2[ in 256ths.
template <class Lanes>
typename Lanes::Real exponent_and_part(typename Lanes::Bits bits) {
  using Real = typename Lanes::Real;
  using Bits = typename Lanes::Bits;
  const Bits top = (bits >> 44) | (Bits{} + 0x42b0000000000000);
  return (Real)top - (Real{} + (0x1p44 + 1023));
}

/// Each is compiled for its instruction set; absent if the target of the compiler is not x86-64.
void power_products_avx2(const PowerProducts& task, const LogarithmTable& table);
void power_products_avx512(const PowerProducts& task, const LogarithmTable& table);

}  // namespace steadyslide::numeric
