#include "proofs_checks/instruments/operators/local_power.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::proofs_checks {
namespace {

/// Returns S(p) for 0 < p < 1. `below_one` is 1 - p, given separately to avoid cancellation close to 1. S is odd.
template <Real R>
R half_line_integral(const R& p, const R& below_one) {
  using std::exp, std::expm1, std::log, std::sinh;
  // The integrand is analytic for |Im tau| < pi. Therefore the error of the rule is exp(-2 pi^2/h); h is chosen so that
  // it is below rounding.
  const R depth = 5 - log(numeric::epsilon<R>());
  const R h = 2 * numeric::pi<R>() * numeric::pi<R>() / depth;
  R sum = p;
  R tau = h;
  for (; 2 * tau < depth; tau += h) sum += 2 * sinh(R(p * tau)) / sinh(tau);
  // For larger tau, sinh(tau) is exp(tau)/2, and the terms are two geometric series.
  const auto series = [&](const R& rate) { return R(-exp(R(-rate * tau)) / expm1(R(-rate * h))); };
  sum += 2 * (series(below_one) - series(R(1 + p)));
  return sum * h / numeric::pi<R>();
}

/// The values m(p) and n(p), 0 < |p| < 1.
template <class R>
struct Symbol {
  R m;
  R n;
  R difference;  ///< n^2 - m^2, computed without cancellation
};

template <Real R>
Symbol<R> local_symbol(const R& p) {
  // The power in ]-1, 0[ is p or p - 1. `above` is its distance from 0, `below` its distance from -1, both without
  // cancellation.
  const R above = p < 0 ? R(-p) : R(1 - p);
  const R below = p < 0 ? R(1 + p) : p;
  const R sum = half_line_integral<R>(below, above);
  const R rest = -half_line_integral<R>(above, below);
  const R n = (sum - rest) / 2;
  return {R((sum + rest) / 2), p < 0 ? n : R(-n), R(-sum * rest)};
}

/// Returns the residual of the equation at y = 1 for a density on one side.
template <Real R>
R end_residual(Side contact, const R& s, const R& p) {
  const R m = local_symbol(p).m;
  return contact == Side::right ? R(s + m) : R(s - m);
}

/// Returns the determinant of the equations at y = 1 and y = -1 for the two amplitudes.
template <Real R>
R jump_residual(const R& s_left, const R& s_right, const R& p) {
  const Symbol<R> at = local_symbol(p);
  return s_left * s_right + at.m * (s_left - s_right) + at.difference;
}

/// Returns a change of sign between low and high, by bisection down to rounding.
template <class F>
double bisected(const F& residual, double low, double high) {
  const bool sign = residual(low) > 0;
  for (int k = 0; k < 120; ++k) {
    const double middle = low + (high - low) / 2;
    (residual(middle) > 0) == sign ? low = middle : high = middle;
  }
  return low + (high - low) / 2;
}

/// Returns the root to all digits, by secants from a root in double.
template <Real R, class F>
R refined(const F& residual, double root) {
  using std::abs;
  R before = root - 1e-9 * std::min(std::abs(root), 1 - std::abs(root));
  R now = root;
  R residual_before = residual(before);
  for (int k = 0; k < 15; ++k) {
    const R residual_now = residual(now);
    if (residual_now == residual_before) break;
    const R step = residual_now * (now - before) / (residual_now - residual_before);
    before = now;
    residual_before = residual_now;
    now -= step;
    if (abs(step) <= 4 * numeric::epsilon<R>() * abs(now)) break;
  }
  return now;
}

constexpr double least = 1e-18;

}  // namespace

template <Real R>
R end_power(Side contact, EndTraction end, const R& s) {
  const auto in_double = static_cast<double>(s);
  const auto coarse = [&](double p) { return end_residual<double>(contact, in_double, p); };
  const double root =
      end == EndTraction::unbounded ? bisected(coarse, -1 + 1e-15, -least) : bisected(coarse, least, 1 - 1e-15);
  return refined<R>([&](const R& p) { return end_residual<R>(contact, s, p); }, root);
}

template <Real R>
JumpPower<R> jump_power(const R& s_left, const R& s_right) {
  const auto left = static_cast<double>(s_left);
  const auto right = static_cast<double>(s_right);
  const auto coarse = [&](double p) { return jump_residual<double>(left, right, p); };
  for (const int sign : {-1, 1}) {
    if ((coarse(sign * 0.5) > 0) == (coarse(sign * least) > 0)) continue;
    const double root = bisected(coarse, sign * least, sign * 0.5);
    const R p = refined<R>([&](const R& at) { return jump_residual<R>(s_left, s_right, at); }, root);
    const Symbol<R> at = local_symbol(p);
    return {p, R((at.m + s_right) / at.n)};
  }
  return {R(0), R(1)};
}

#define STEADYSLIDE_INSTANTIATE(R)                   \
  template R end_power(Side, EndTraction, const R&); \
  template JumpPower<R> jump_power(const R&, const R&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::proofs_checks
