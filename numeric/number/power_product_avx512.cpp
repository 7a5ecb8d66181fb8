// Compiled for AVX-512 (numeric/CMakeLists.txt), and called if the processor has it.

#include "numeric/number/power_product_kernel.hpp"

// g++ 12 warns of the intrinsics' undefined vectors (GCC bug 105593).
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#ifdef __AVX512F__
#include <immintrin.h>

namespace steadyslide::numeric {
namespace {

struct Avx512Lanes {
  static constexpr std::size_t count = 8;
  using Real [[gnu::vector_size(64)]] = double;
  using Bits [[gnu::vector_size(64)]] = std::uint64_t;
  struct Reduced {
    Real r, high, low;
  };

  static Real multiply_add(Real a, Real b, Real c) { return _mm512_fmadd_pd(a, b, c); }

  static Reduced reduced(Bits bits, const LogarithmTable& table) {
    const Bits at = (bits >> 43) & (Bits{} + 0x1fe);
    const Real inverse = _mm512_i64gather_pd((__m512i)at, &table.rows[0].inverse, 8);
    const Real high = _mm512_i64gather_pd((__m512i)at, &table.rows[0].high, 8);
    const Real m = (Real)((bits & (Bits{} + 0x000fffffffffffff)) | (Bits{} + 0x3ff0000000000000));
    return {multiply_add(m, inverse, Real{} - 1), exponent_and_part<Avx512Lanes>(bits) + high, Real{}};
  }
};

}  // namespace

void power_products_avx512(const PowerProducts& task, const LogarithmTable& table) {
  PowerProductKernel<Avx512Lanes>(task, table).run();
}

}  // namespace steadyslide::numeric
#endif
