#include "numeric/layers/body_kernel.hpp"

#include <stdexcept>

#include "numeric/layers/symbol_transform.hpp"
#include "numeric/number/chebyshev.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
constexpr std::size_t chebyshev_nodes = std::same_as<R, double>   ? 28
                                        : std::same_as<R, Real50> ? 72
                                                                  : 136;

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
    static const ChebyshevPoints<R> points(chebyshev_nodes<R>);
    R left = 0;
    R length = 40 / last_wave_number;
    R tail_before = infinity<R>();
    while (left < reach) {
      const R right = left + 5 * length / 4 >= reach ? reach : R(left + length);
      std::vector<R> n;
      std::vector<R> t;
      R largest = 0;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const auto slopes = transform.at(R(left + (right - left) * (1 + points.place(k)) / 2));
        n.push_back(slopes.normal);
        t.push_back(slopes.coupling);
        largest = max(largest, R(max(abs(n.back()), abs(t.back()))));
      }
      n = points.series(n);
      t = points.series(t);
      // The second term is the size of the parts that cancel.
      const R tolerance = 8 * series_accuracy<R>() * (largest + transform.largest_defect() / right);
      const R tail = tail_of(n, t);
      if (is_exact(tail, tail_before, tolerance)) {
        drop_tail(n, tolerance);
        drop_tail(t, tolerance);
        normal.push_back({left, right, std::move(n)});
        coupling.push_back({left, right, std::move(t)});
        left = right;
        tail_before = infinity<R>();
        length *= tail <= tolerance ? 2 : 4;  // a panel at its rounding errors takes two trials
      } else {
        length = (right - left) / 2;
        tail_before = tail;
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
