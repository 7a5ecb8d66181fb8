#pragma once
// Short forms for periodic contact, and its operator applied by a rule that no solver uses.

#include "numeric/solution/contact_solution.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"

namespace steadyslide::testing {

/// s itself is the datum, as in reduced().
inline ContactProblem periodic(const Rational& period, std::vector<Rational> s, const std::vector<Rational>& jumps,
                               const Indenter& indenter, const Rational& load = 1, Sliding sliding = Sliding::plus_x) {
  return reduced(std::move(s), jumps, indenter, load, std::nullopt, sliding).with_body(Body::periodic(period));
}

inline Indenter flat(const Rational& left, const Rational& right) { return one_piece(left, right, {0}); }

/// int f over ]a, b[ by the trapezoidal rule in v, x = a + (b - a) (1 + tanh(pi/2 sinh v))/2. f takes the exact place.
template <numeric::Real R, class F>
R integral(const Rational& a, const Rational& b, const F& f) {
  using namespace numeric;
  const R step = std::same_as<R, double> ? R(1) / 16 : R(1) / 32, most = std::same_as<R, double> ? R(5) : R(7);
  R sum = 0;
  for (int k = -static_cast<int>(most / step); step * k <= most; ++k) {
    const R v = step * k, u = pi<R>() / 2 * sinh(abs(v));
    const R near = 1 / (1 + exp(2 * u));  // the distance from the nearer end, as a part of b - a
    const Rational d = Rational(near) * (b - a);
    const R weight = pi<R>() / 4 * cosh(v) / (cosh(u) * cosh(u)) * to_real<R>(b - a);
    if (weight > 0 && d > 0) sum += weight * f(v < 0 ? Rational(a + d) : Rational(b - d));
  }
  return step * sum;
}

/// Returns A_L t at a place that is no singular point, from the tractions of a solution alone. `points` are the singular
/// points, with the ends of the contact.
template <numeric::Real R>
R applied(const ContactProblem& problem, const numeric::ContactSolution<R>& solution,
          const std::vector<Rational>& points, const Rational& x) {
  using namespace numeric;
  const Rational& period = *problem.body().period();
  const R wave = pi<R>() / to_real<R>(period);
  const auto t = [&](const Rational& place) { return solution.at(place).traction.left.value; };
  const auto s = [&](const Rational& place) {
    return to_real<R>(problem.coupled_friction(problem.friction().piece(place, Side::left)));
  };
  R sum = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const auto kernel = [&](const Rational& place) -> R { return t(place) / tan(wave * to_real<R>(place - x)); };
    const auto friction = [&](const Rational& place) -> R { return t(place) * s(place); };
    sum -= integral<R>(points[k], points[k + 1], friction);
    if (x < points[k] || x > points[k + 1]) {
      sum += integral<R>(points[k], points[k + 1], kernel);
      continue;
    }
    const Rational d = std::min(x - points[k], points[k + 1] - x) / 2;
    sum += integral<R>(points[k], x - d, kernel) + integral<R>(x + d, points[k + 1], kernel);
    sum += integral<R>(0, d, [&](const Rational& y) -> R { return (t(x + y) - t(x - y)) / tan(wave * to_real<R>(y)); });
    sum += s(x) * t(x) * to_real<R>(period);
  }
  return sum / to_real<R>(period);
}

}  // namespace steadyslide::testing
