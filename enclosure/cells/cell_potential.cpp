#include "enclosure/cells/cell_potential.hpp"

#include <cstdlib>

#include "enclosure/cells/gap_part.hpp"
#include "enclosure/cells/toeplitz_sums.hpp"

namespace steadyslide::enclosure {
namespace {

/// Second differences of T lose twice the bits of N.
constexpr Bits spare = 96;

/// Logarithms of whole and half numbers, and what is made of them.
class Logarithms {
 public:
  Logarithms(std::size_t n, Bits bits) : bits_(bits) {
    const Ball two(2, bits);
    const Ball log_two = log(two);
    for (std::size_t k = 0; k <= n + 2; ++k) {
      // log 0 is never asked for by itself: l and T are 0 there.
      whole_.push_back(k == 0 ? Ball(0, bits) : log(number(k)));
      half_.push_back(log(number(2 * k + 1)) - log_two);
    }
  }

  Ball number(std::size_t k) const { return {static_cast<int>(k), bits_}; }
  /// l(k) = k log k.
  Ball l(std::size_t k) const { return number(k) * whole_[k]; }
  /// T(k) = k^2/2 log k.
  Ball twice(std::size_t k) const { return number(k) * number(k) * whole_[k] / Ball(2); }
  Ball a(std::size_t k) const { return Ball(2) * (l(k) + l(k + 1)) - Ball(2) * number(2 * k + 1) * half_[k]; }
  Ball b(std::size_t k) const { return Ball(4) * (l(k + 1) - l(k) - half_[k] - Ball(1)); }
  Ball rest(std::size_t k) const { return Ball(1, bits_) / (Ball(48) * number(k) * number(k) * number(k)); }
  Ball mean(std::size_t d) const {
    const std::size_t before = d == 0 ? 1 : d - 1;  // T is even
    return twice(d + 1) - Ball(2) * twice(d) + twice(before) - Ball(1, bits_) / Ball(2);
  }

 private:
  Bits bits_;
  std::vector<Ball> whole_;
  std::vector<Ball> half_;
};

/// k_d for d = -(weights - 1)..count - 1.
template <class F>
std::vector<Ball> kernel(std::size_t weights, std::size_t count, const F& f) {
  std::vector<Ball> result;
  result.reserve(weights + count - 1);
  for (std::size_t k = weights - 1; k > 0; --k) result.push_back(f(-static_cast<long>(k)));
  for (std::size_t k = 0; k < count; ++k) result.push_back(f(static_cast<long>(k)));
  return result;
}

std::size_t size(long d) { return static_cast<std::size_t>(std::abs(d)); }

}  // namespace

CellPotential::CellPotential(const CellPressures& pressures, Bits fraction) : rises_(pressures.rises()) {
  const std::size_t n = pressures.size();
  const Logarithms logs(n, fraction + spare);
  const auto sums = [&](const std::vector<std::int64_t>& weights, std::size_t count, const auto& f) {
    return toeplitz_sums(weights, kernel(weights.size(), count, f), count, fraction);
  };
  // Cell j lies right of node i for d = i - j <= 0.
  nodes_ = sums(pressures.weights(), n + 1, [&](long d) {
    const std::size_t k = d > 0 ? size(d) - 1 : size(d);
    return logs.l(k + 1) - logs.l(k);
  });
  means_ = sums(pressures.weights(), n, [&](long d) { return logs.mean(size(d)); });
  // Node m lies at the cell's left end or left of it for d = i - m >= 0, at its right end for d = -1.
  const auto beyond = [](long d) { return d >= 0 ? size(d) : size(d) - 1; };
  const auto far = [&](const auto& f) {
    return [&logs, &beyond, f](long d) {
      const std::size_t k = beyond(d);
      return k < near ? Ball(0) : f(d, k);
    };
  };
  bend_ = sums(rises_, n, far([&](long d, std::size_t k) { return d > 0 ? logs.a(k) : -logs.a(k); }));
  skew_ = sums(rises_, n, far([&](long, std::size_t k) { return logs.b(k); }));
  std::vector<std::int64_t> sizes = rises_;
  for (std::int64_t& r : sizes) r = std::abs(r);
  rest_ = sums(sizes, n, far([&](long, std::size_t k) { return logs.rest(k); }));
}

}  // namespace steadyslide::enclosure
