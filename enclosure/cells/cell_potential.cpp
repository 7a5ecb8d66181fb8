#include "enclosure/cells/cell_potential.hpp"

#include <flint/fmpz_poly.h>

#include <cstdlib>
#include <stdexcept>

#include "enclosure/cells/gap_part.hpp"

namespace steadyslide::enclosure {
namespace {

/// Second differences of T lose twice the number of bits of N.
constexpr Bits spare = 96;

/// Logarithms of integers and half-integers, and functions of them.
class Logarithms {
 public:
  Logarithms(std::size_t n, Bits bits) : bits_(bits) {
    const Ball two(2, bits);
    const Ball log_two = log(two);
    for (std::size_t k = 0; k <= n + 2; ++k) {
      // log 0 is never used alone: l and T are 0 there.
      whole_.push_back(k == 0 ? Ball(0, bits) : log(number(k)));
      half_.push_back(log(number(2 * k + 1)) - log_two);
    }
  }

  Ball number(std::size_t k) const { return {static_cast<int>(k), bits_}; }
  /// Returns l(k) = k log k.
  Ball l(std::size_t k) const { return number(k) * whole_[k]; }
  /// Returns T(k) = k^2/2 log k.
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

/// A polynomial with integer coefficients, and an integer.
struct WholePolynomial {
  explicit WholePolynomial(std::size_t length) { fmpz_poly_init2(value, static_cast<slong>(length)); }
  WholePolynomial(const WholePolynomial&) = delete;
  WholePolynomial& operator=(const WholePolynomial&) = delete;
  ~WholePolynomial() { fmpz_poly_clear(value); }
  fmpz_poly_t value;
};

struct WholeNumber {
  WholeNumber() { fmpz_init(value); }
  WholeNumber(const WholeNumber&) = delete;
  WholeNumber& operator=(const WholeNumber&) = delete;
  ~WholeNumber() { fmpz_clear(value); }
  fmpz_t value;
};

/// Returns enclosures of the sums r_i = sum_j w_j k_{i-j}, i = 0..count-1, for integers w and enclosed numbers k.
///
/// Each k is rounded to an integer K of units 2^-fraction. Then sum w_j K_{i-j} is an exact coefficient of a product of
/// two polynomials with integer coefficients (FLINT). If |k - 2^-fraction K| <= e for every k, then
///   |r_i - 2^-fraction sum w_j K_{i-j}| <= e sum |w_j|.
///
/// `kernel` is called for d = -(weights.size() - 1) up to count - 1. Throws std::invalid_argument if it is not finite.
template <class Kernel>
std::vector<Ball> toeplitz_sums(const std::vector<std::int64_t>& weights, std::size_t count, const Kernel& kernel,
                                Bits fraction) {
  const auto n = static_cast<slong>(weights.size()), m = static_cast<slong>(count);
  WholePolynomial w(weights.size()), k(weights.size() + count), product(2 * weights.size() + count);
  Ball sum_of_sizes(0, fraction);
  for (slong j = 0; j < n; ++j) {
    const std::int64_t weight = weights[static_cast<std::size_t>(j)];
    fmpz_poly_set_coeff_si(w.value, j, weight);
    arb_add_ui(sum_of_sizes.get(), sum_of_sizes.get(), static_cast<ulong>(std::abs(weight)), fraction);
  }
  Ball widest(0, 64);
  WholeNumber number;
  for (slong d = 1 - n; d < m; ++d) {
    const Ball value = kernel(d);
    if (!value.is_finite()) throw std::invalid_argument("a kernel that is not finite");
    // Truncated by less than one unit.
    arf_get_fmpz_fixed_si(number.value, arb_midref(value.get()), -fraction);
    fmpz_poly_set_coeff_fmpz(k.value, d + n - 1, number.value);
    widest = max(widest, value.radius().at(64));
  }
  const Ball unit = made_by(arb_mul_2exp_si, 64, Ball(1).get(), -fraction);
  const Ball error = (widest + unit) * sum_of_sizes;

  fmpz_poly_mul(product.value, w.value, k.value);
  std::vector<Ball> result;
  for (slong i = 0; i < m; ++i) {
    fmpz_poly_get_coeff_fmpz(number.value, product.value, i + n - 1);
    Ball sum = made_by(arb_set_round_fmpz, fraction, number.value, fraction);
    arb_mul_2exp_si(sum.get(), sum.get(), -fraction);
    result.push_back(Ball::plus_or_minus(sum, error));
  }
  return result;
}

std::size_t size(long d) { return static_cast<std::size_t>(std::abs(d)); }

}  // namespace

CellPotential::CellPotential(const CellPressures& pressures, Bits fraction) : rises(pressures.rises()) {
  const std::size_t n = pressures.size();
  const Logarithms logs(n, fraction + spare);
  const auto sums = [&](const std::vector<std::int64_t>& weights, std::size_t count, const auto& f) {
    return toeplitz_sums(weights, count, f, fraction);
  };
  // Cell j lies right of node i for d = i - j <= 0.
  nodes = sums(pressures.weights(), n + 1, [&](long d) {
    const std::size_t k = d > 0 ? size(d) - 1 : size(d);
    return logs.l(k + 1) - logs.l(k);
  });
  means = sums(pressures.weights(), n, [&](long d) { return logs.mean(size(d)); });
  // Node m lies at the cell's left end or left of it for d = i - m >= 0, at its right end for d = -1.
  const auto beyond = [](long d) { return d >= 0 ? size(d) : size(d) - 1; };
  const auto far = [&](const auto& f) {
    return [&beyond, f](long d) {
      const std::size_t k = beyond(d);
      return k < near ? Ball(0) : f(d, k);
    };
  };
  bend = sums(rises, n, far([&](long d, std::size_t k) { return d > 0 ? logs.a(k) : -logs.a(k); }));
  skew = sums(rises, n, far([&](long, std::size_t k) { return logs.b(k); }));
  std::vector<std::int64_t> sizes = rises;
  for (std::int64_t& r : sizes) r = std::abs(r);
  rest = sums(sizes, n, far([&](long, std::size_t k) { return logs.rest(k); }));
}

}  // namespace steadyslide::enclosure
