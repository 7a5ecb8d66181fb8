#pragma once
// What a flat punch's friction tends to when its coatings alternate ever faster: A and B of effective_friction.hpp are
// integrals of alpha against functions that do not change, so that only the mean of alpha stays,
//
//   s_eff -> tan(pi <alpha>),   for s >= 0 at most the mean of s (Jensen: tan is convex there).
//
// N periods are slow: next to the rear end, at distances d of a period, A differs from its limit by a number, and there lies
// int_0^(1/N) d^(-1/2 - <alpha>) dd of the integral; at the front end the same with +<alpha>. Sliding towards +x
//
//   s_eff(N) - s_eff(oo) ~ C N^-(1/2 - <alpha>),
//
// with the sign of C that of the outermost coating: rougher than the mean, it costs more. The term of the front end,
// N^-(1/2 + <alpha>), is next: where <alpha> is small both have to be told apart before an order can be measured.

#include "numeric/flat_punch/friction_layout.hpp"
#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

template <Real R>
struct FineMixture {
  Estimate<R> s_eff;  ///< tan(pi <alpha>)
  R order;            ///< 1/2 - |<alpha>|: the power of 1/N with which N periods come near
};

/// Shares of the contact, whose sum is 1, each with its s.
template <Real R>
FineMixture<R> fine_mixture(const std::vector<Rational>& shares, const std::vector<Rational>& s);

/// The smaller order p in e(N) = C N^-p + D N^-(1-p), from e(N), e(2N) and e(4N): 2^-p and 2^-(1-p) have the product 1/2 and
/// the sum (e(4N) + e(N)/2)/e(2N).
template <Real R>
R order_of_periods(const R& e, const R& doubled, const R& doubled_twice);

}  // namespace steadyslide::numeric
