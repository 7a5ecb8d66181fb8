#include "numeric/flat_punch/extreme_layout.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <stdexcept>

namespace steadyslide::numeric {
namespace {

/// outer | inner | outer, by the logarithm tau of the ratio of the outer strips' lengths.
template <Real R>
struct Sandwich {
  std::vector<Rational> s;
  R inner;
  R room;  ///< of both outer strips together

  R left(const R& tau) const {
    using std::exp;
    return room / (1 + exp(-tau));
  }
  R right(const R& tau) const { return left(-tau); }
  FrictionLayout<R> at(const R& tau) const { return {{left(tau), inner, right(tau)}, s}; }

  /// w at the first jump minus w at the second one: falls as tau grows.
  Estimate<R> difference(const R& tau) const {
    const EffectiveFriction<R> friction(at(tau));
    return friction.derivative(left(tau), inner + right(tau)) - friction.derivative(left(tau) + inner, right(tau));
  }
};

/// The zero of the difference, and the slope there.
struct Start {
  double zero;
  double slope;
};

Start zero_in_double(const Sandwich<double>& sandwich) {
  const auto difference = [&](double tau) { return sandwich.difference(tau).value; };
  double low = -1;
  double high = 1;
  // The infinite limits of w end that; next to 1/2 - alpha = 0 they are those of a logarithm.
  constexpr double furthest = 600;
  while (low >= -furthest && !(difference(low) > 0)) low *= 2;
  while (high <= furthest && !(difference(high) < 0)) high *= 2;
  if (low < -furthest || high > furthest) throw std::range_error("a strip is shorter than 1e-200 of the contact");
  boost::uintmax_t steps = 200;
  // The last digits belong to the rounding of w, not to its zero.
  const boost::math::tools::eps_tolerance<double> tolerance(std::numeric_limits<double>::digits - 8);
  const auto [left, right] = boost::math::tools::toms748_solve(difference, low, high, tolerance, steps);
  const double zero = (left + right) / 2;
  constexpr double step = 1e-4;
  return {zero, (difference(zero + step) - difference(zero - step)) / (2 * step)};
}

/// Secants from what double has found: the digits that are right add up.
template <Real R>
Estimate<R> zero_of(const Sandwich<R>& sandwich, const Start& start) {
  using std::abs;
  R slope = start.slope;
  R tau = start.zero;
  Estimate<R> difference = sandwich.difference(tau);
  const auto error = [&] { return R(2 * difference.error / abs(slope) + 16 * epsilon<R>() * (1 + abs(tau))); };
  constexpr int most_steps = 12;
  for (int i = 0; i < most_steps && abs(difference.value) > difference.error; ++i) {
    const R step = -difference.value / slope;
    const Estimate<R> next = sandwich.difference(tau + step);
    if (abs(step) > error()) slope = (next.value - difference.value) / step;
    tau += step;
    difference = next;
  }
  return {tau, error() + abs(difference.value / slope)};
}

template <Real R>
Sandwich<R> sandwich_of(const Rational& outer, const Rational& inner, const Rational& inner_share) {
  return {{outer, inner, outer}, to_real<R>(inner_share), to_real<R>(1 - inner_share)};
}

}  // namespace

template <Real R>
ExtremeLayout<R> extreme_layout(const Rational& s_outer, const Rational& s_inner, const Rational& inner_share) {
  if (s_outer == s_inner) throw std::invalid_argument("two coatings of one friction");
  if (inner_share <= 0 || inner_share >= 1) throw std::invalid_argument("a share is between 0 and 1");
  const auto sandwich = sandwich_of<R>(s_outer, s_inner, inner_share);
  const Start start = zero_in_double(sandwich_of<double>(s_outer, s_inner, inner_share));
  const Estimate<R> tau = zero_of(sandwich, start);
  const R left = sandwich.left(tau.value);
  const R right = sandwich.right(tau.value);
  const R error = left * right / sandwich.room * tau.error;
  FrictionLayout<R> layout = sandwich.at(tau.value);
  return {{left, error}, {right, error}, layout, EffectiveFriction<R>(layout).value()};
}

template ExtremeLayout<double> extreme_layout(const Rational&, const Rational&, const Rational&);
template ExtremeLayout<Real50> extreme_layout(const Rational&, const Rational&, const Rational&);
template ExtremeLayout<Real100> extreme_layout(const Rational&, const Rational&, const Rational&);

}  // namespace steadyslide::numeric
