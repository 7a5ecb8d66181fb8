#include "enclosure/cells/toeplitz_sums.hpp"

#include <flint/fmpz_poly.h>

#include <stdexcept>

namespace steadyslide::enclosure {
namespace {

/// A polynomial with whole coefficients.
class WholePolynomial {
 public:
  explicit WholePolynomial(std::size_t length) { fmpz_poly_init2(value_, static_cast<slong>(length)); }
  WholePolynomial(const WholePolynomial&) = delete;
  WholePolynomial& operator=(const WholePolynomial&) = delete;
  ~WholePolynomial() { fmpz_poly_clear(value_); }
  fmpz_poly_struct* get() { return value_; }

 private:
  fmpz_poly_t value_;
};

class Whole {
 public:
  Whole() { fmpz_init(value_); }
  Whole(const Whole&) = delete;
  Whole& operator=(const Whole&) = delete;
  ~Whole() { fmpz_clear(value_); }
  fmpz* get() { return value_; }

 private:
  fmpz_t value_;
};

}  // namespace

std::vector<Ball> toeplitz_sums(const std::vector<std::int64_t>& weights, const std::vector<Ball>& kernel,
                                std::size_t count, Bits fraction) {
  const std::size_t n = weights.size();
  if (n == 0 || kernel.size() != n + count - 1) throw std::invalid_argument("length of a kernel");
  WholePolynomial w(n), k(kernel.size()), product(n + kernel.size());
  Ball sum_of_sizes(0, fraction);
  for (std::size_t j = 0; j < n; ++j) {
    fmpz_poly_set_coeff_si(w.get(), static_cast<slong>(j), weights[j]);
    arb_add_ui(sum_of_sizes.get(), sum_of_sizes.get(), static_cast<ulong>(std::abs(weights[j])), fraction);
  }
  Ball widest(0, 64);
  Whole number;
  for (std::size_t d = 0; d < kernel.size(); ++d) {
    if (!kernel[d].is_finite()) throw std::invalid_argument("a kernel that is not finite");
    // Cut off, by less than a unit.
    arf_get_fmpz_fixed_si(number.get(), arb_midref(kernel[d].get()), -fraction);
    fmpz_poly_set_coeff_fmpz(k.get(), static_cast<slong>(d), number.get());
    widest = max(widest, kernel[d].radius().at(64));
  }
  const Ball unit = made_by(arb_mul_2exp_si, 64, Ball(1).get(), -fraction);
  const Ball error = (widest + unit) * sum_of_sizes;

  fmpz_poly_mul(product.get(), w.get(), k.get());
  std::vector<Ball> result;
  for (std::size_t i = 0; i < count; ++i) {
    fmpz_poly_get_coeff_fmpz(number.get(), product.get(), static_cast<slong>(i + n - 1));
    Ball sum(0, fraction);
    arb_set_round_fmpz(sum.get(), number.get(), fraction);
    arb_mul_2exp_si(sum.get(), sum.get(), -fraction);
    result.push_back(Ball::plus_or_minus(sum, error));
  }
  return result;
}

}  // namespace steadyslide::enclosure
