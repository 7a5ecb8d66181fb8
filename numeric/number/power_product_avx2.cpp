// Compiled for AVX2 and FMA (numeric/CMakeLists.txt), and called if the processor has them.

#include "numeric/number/power_product_kernel.hpp"

#ifdef __AVX2__
#include <immintrin.h>

namespace steadyslide::numeric {
namespace {

struct Avx2Lanes {
  static constexpr std::size_t count = 4;
  using Real [[gnu::vector_size(32)]] = double;
  using Bits [[gnu::vector_size(32)]] = std::uint64_t;
  struct Reduced {
    Real r, high, low;
  };

  static Real multiply_add(Real a, Real b, Real c) { return _mm256_fmadd_pd(a, b, c); }

  static Reduced reduced(Bits bits, const LogarithmTable& table) {
    // Load rows of 16 bytes, two at a time, and then sort by columns. This is faster than a gather.
    const Bits offset = (bits >> 40) & (Bits{} + 0xff0);
    std::uint64_t at[4];
    __builtin_memcpy(at, &offset, sizeof at);
    const auto row = [&](int lane) {
      return _mm_load_pd(reinterpret_cast<const double*>(reinterpret_cast<const char*>(table.rows) + at[lane]));
    };
    const __m256d even = _mm256_insertf128_pd(_mm256_castpd128_pd256(row(0)), row(2), 1);
    const __m256d odd = _mm256_insertf128_pd(_mm256_castpd128_pd256(row(1)), row(3), 1);
    const Real inverse = _mm256_unpacklo_pd(even, odd);
    const Real high = _mm256_unpackhi_pd(even, odd);
    const Real m = (Real)((bits & (Bits{} + 0x000fffffffffffff)) | (Bits{} + 0x3ff0000000000000));
    return {multiply_add(m, inverse, Real{} - 1), exponent_and_part<Avx2Lanes>(bits) + high, Real{}};
  }
};

}  // namespace

void power_products_avx2(const PowerProducts& task, const LogarithmTable& table) {
  PowerProductKernel<Avx2Lanes>(task, table).run();
}

}  // namespace steadyslide::numeric
#endif
