#include "numeric/layers/body_kernel.hpp"

#include <stdexcept>

#include "numeric/layers/symbol_transform.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
constexpr std::size_t chebyshev_nodes = std::same_as<R, double>   ? 28
                                        : std::same_as<R, Real50> ? 72
                                                                  : 136;

/// Chebyshev's points on [-1, 1], and the coefficients of the series through values there.
template <Real R>
struct ChebyshevPoints {
  static constexpr std::size_t n = chebyshev_nodes<R>;
  std::vector<R> cosines;  ///< of pi k/(2n), k = 0..4n-1

  ChebyshevPoints() {
    for (std::size_t k = 0; k < 4 * n; ++k)
      cosines.push_back(cos(R(pi<R>() * static_cast<int>(k) / (2 * static_cast<int>(n)))));
  }
  R place(std::size_t k) const { return cosines[2 * k + 1]; }
  std::vector<R> series(const std::vector<R>& values) const {
    std::vector<R> result;
    for (std::size_t m = 0; m < n; ++m) {
      R sum = 0;
      for (std::size_t k = 0; k < n; ++k) sum += values[k] * cosines[m * (2 * k + 1) % (4 * n)];
      result.push_back(sum * (m == 0 ? 1 : 2) / static_cast<int>(n));
    }
    return result;
  }
};

template <Real R>
using Panels = std::vector<typename KernelFunction<R>::Panel>;

}  // namespace

template <Real R>
struct BodyKernel<R>::Slopes {
  Panels<R> normal;
  Panels<R> coupling;

  R at_zero;
  bool absolute;

  Slopes(const BodySymbols<R>& symbols, const R& reach) : absolute(symbols.has_absolute_displacement()) {
    if (!(reach > 0)) throw std::invalid_argument("the reach of a kernel must be positive");
    const SymbolTransform<R> transform(symbols);
    const R& last_wave_number = symbols.last_wave_number();
    at_zero = transform.normal_at_zero();
    if (last_wave_number == 0) return;
    static const ChebyshevPoints<R> points;
    R left = 0;
    R length = 40 / last_wave_number;
    while (left < reach) {
      const R right = left + 5 * length / 4 >= reach ? reach : R(left + length);
      std::vector<R> n;
      std::vector<R> t;
      R largest = 0;
      for (std::size_t k = 0; k < ChebyshevPoints<R>::n; ++k) {
        const auto slopes = transform.at(R(left + (right - left) * (1 + points.place(k)) / 2));
        n.push_back(slopes.normal);
        t.push_back(slopes.coupling);
        largest = max(largest, R(max(abs(n.back()), abs(t.back()))));
      }
      n = points.series(n);
      t = points.series(t);
      // The second term is the size of the parts that cancel.
      const R tolerance = 8 * epsilon<R>() * (largest + transform.largest_defect() / right);
      if (drop_tail(n, tolerance) >= 4 && drop_tail(t, tolerance) >= 4) {
        normal.push_back({left, right, std::move(n)});
        coupling.push_back({left, right, std::move(t)});
        left = right;
        length *= 2;
      } else {
        length = (right - left) / 2;
        if (length * last_wave_number < 0.01) throw std::runtime_error("the kernel of a body has no Chebyshev series");
      }
    }
  }
};

template <Real R>
BodyKernel<R>::BodyKernel(const BodySymbols<R>& symbols, const R& reach) : BodyKernel(Slopes(symbols, reach)) {}

template <Real R>
BodyKernel<R>::BodyKernel(const Slopes& slopes)
    : normal_slope_(Parity::odd, slopes.normal),
      coupling_slope_(Parity::even, slopes.coupling),
      normal_(normal_slope_.antiderivative(slopes.at_zero)),
      coupling_(coupling_slope_.antiderivative(R(0))),
      absolute_(slopes.absolute) {}

STEADYSLIDE_INSTANTIATE_CLASS(BodyKernel)

}  // namespace steadyslide::numeric
