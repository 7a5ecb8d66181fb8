#pragma once
// Logarithm, exponential and power of the MPFR numbers of real.hpp, by Arb's balls: the midpoint of a ball computed
// with 16 bits to spare, rounded to nearest,
//
//   |result - f(x)| <= (1/2 + 2^-7) ulp,
//
// because a ball is used only if its radius is below 2^-7 of the last bit. MPFR's own function computes the other
// cases, and all special cases (0, infinity, a negative logarithm, a huge exponent). This is three to six times as fast
// as MPFR (tests/bench/README.md). MPFR computes products, quotients and sums, because Arb would have to convert the numbers.
//
// Boost's log(), exp() and pow() of these numbers use these functions: they call eval_log, eval_exp and eval_pow of the
// backend, and the overloads below are more specialised than Boost's. eval_beta() uses MPFR. There is no state, so all
// functions are thread-safe.

#include <boost/multiprecision/mpfr.hpp>
#include <memory>

namespace steadyslide::numeric::elementary {

// `result` may be the argument.
void log(mpfr_ptr result, mpfr_srcptr x);
void exp(mpfr_ptr result, mpfr_srcptr x);
void pow(mpfr_ptr result, mpfr_srcptr base, mpfr_srcptr exponent);

/// Computes prod x_j^{p_j} as e^(sum_j p_j log x_j), with one logarithm for each factor and one exponential, in one
/// ball. Each step truncates, with an error of 2^(1 - bits) of its result. For n factors the relative error of the
/// product is below
///
///   (2 n + 4) 2^-bits (1 + sum_j |p_j log x_j|).
class PowerProduct {
 public:
  explicit PowerProduct(mpfr_prec_t bits);
  ~PowerProduct();
  PowerProduct(const PowerProduct&) = delete;
  PowerProduct& operator=(const PowerProduct&) = delete;

  void set_one();
  /// base >= 0.
  void multiply(mpfr_srcptr base, mpfr_srcptr exponent);
  void value(mpfr_ptr result) const;

 private:
  struct Balls;
  std::unique_ptr<Balls> balls_;
};

}  // namespace steadyslide::numeric::elementary

namespace boost::multiprecision::backends {

template <unsigned Digits10>
using StackFloat = mpfr_float_backend<Digits10, allocate_stack>;

template <unsigned Digits10>
void eval_log(StackFloat<Digits10>& result, const StackFloat<Digits10>& x) {
  steadyslide::numeric::elementary::log(result.data(), x.data());
}

template <unsigned Digits10>
void eval_exp(StackFloat<Digits10>& result, const StackFloat<Digits10>& x) {
  steadyslide::numeric::elementary::exp(result.data(), x.data());
}

template <unsigned Digits10>
void eval_pow(StackFloat<Digits10>& result, const StackFloat<Digits10>& base, const StackFloat<Digits10>& exponent) {
  steadyslide::numeric::elementary::pow(result.data(), base.data(), exponent.data());
}

/// Gamma(a) Gamma(b)/Gamma(a + b).
template <unsigned Digits10>
void eval_beta(StackFloat<Digits10>& result, const StackFloat<Digits10>& a, const StackFloat<Digits10>& b) {
  mpfr_beta(result.data(), a.data(), b.data(), MPFR_RNDN);
}

}  // namespace boost::multiprecision::backends
