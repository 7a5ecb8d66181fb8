#pragma once
// The solution of A t = psi' if psi' is one polynomial on the whole contact: it needs no integrals. With Y of
// riemann_hilbert.hpp, S its order at infinity and sigma_k = sum p_j e_j^k,
//
//   Y = z^S exp(-sum sigma_k/(k z^k)),   psi'/Y = Q + c_1/z + c_2/z^2 + ...,
//   F = 2i Phi = psi' - Y N,   N = Q + q,   deg q <= -S-1,   t = (F+ - F-)/(2i) = epsilon cos(pi alpha) |Y| N,
//   F = P/(pi z) + O(1/z^2):   q = -(P/pi) z^{-S-1} + free coefficients if S < 0;
//                              c_1 = ... = c_S = 0 and c_{S+1} = P/pi if S >= 0.
//
// Everything is a polynomial in the sigma_k. The sigma_k are symbols or polynomials.

#include <ginac/ginac.h>

#include <vector>

namespace steadyslide::symbolic {

/// Returns sum p_j e_j^k for k = 1..count.
std::vector<GiNaC::ex> power_sums(const std::vector<GiNaC::ex>& powers, const std::vector<GiNaC::ex>& places,
                                  std::size_t count);
/// Returns symbols sigma_1, sigma_2, ...
std::vector<GiNaC::ex> power_sum_symbols(std::size_t count);

/// Returns exp(sign * sum sigma_k u^k/k) up to u^count. sign = -1 gives z^{-S} Y, sign = +1 gives z^S/Y, in u = 1/z.
std::vector<GiNaC::ex> series_at_infinity(const std::vector<GiNaC::ex>& sums, int sign, std::size_t count);
/// Returns prod (1 - e_j u)^{p_j} up to u^count, by binomial series. This is an independent way to compute sign = -1.
std::vector<GiNaC::ex> binomial_product(const std::vector<GiNaC::ex>& powers, const std::vector<GiNaC::ex>& places,
                                        std::size_t count);

class PolynomialSlope {
 public:
  /// Takes the coefficients of 1, x, ... in psi' and as many power sums as `sums_needed` returns.
  PolynomialSlope(int order, std::vector<GiNaC::ex> slope, const std::vector<GiNaC::ex>& sums,
                  const GiNaC::ex& load_over_pi);
  static std::size_t sums_needed(int order, std::size_t slope_size);

  int order() const { return order_; }
  /// The coefficients of N.
  const std::vector<GiNaC::ex>& factor() const { return factor_; }
  /// The expressions that must vanish: c_1, ..., c_S, c_{S+1} - P/pi; empty if S < 0.
  const std::vector<GiNaC::ex>& conditions() const { return conditions_; }
  /// The coefficients of q that the gaps between components determine.
  const std::vector<GiNaC::ex>& free_coefficients() const { return free_coefficients_; }

 private:
  int order_;
  std::vector<GiNaC::ex> slope_;
  std::vector<GiNaC::ex> factor_;
  std::vector<GiNaC::ex> conditions_;
  std::vector<GiNaC::ex> free_coefficients_;
};

/// Returns the coefficient of z^power in F = psi' - Y N, from the series of z^{-S} Y.
GiNaC::ex field_coefficient(int order, const std::vector<GiNaC::ex>& slope, const std::vector<GiNaC::ex>& factor,
                            const std::vector<GiNaC::ex>& series, int power);

}  // namespace steadyslide::symbolic
