#pragma once
// Finds the extremes of a function from its values and differences alone. The function is a pressure between two
// singular points, and analytic there.

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>

#include "proofs_checks/instruments/solutions/local_behaviour.hpp"

namespace steadyslide::proofs_checks {

/// Returns the extremes in ]from, to[ from left to right. Evaluates f at points that are dense towards both ends.
template <Real R, class F>
std::vector<R> extremes_between(const F& f, const R& from, const R& to) {
  using std::min, std::sin;
  constexpr int points = 100;
  const auto place = [&](int k) {
    const R sine = sin(R(numeric::pi<R>() * k / (2 * points)));
    return R(from + (to - from) * sine * sine);
  };
  const auto slope = [&](const R& x) { return derivative<R>(f, x, min(R(x - from), R(to - x))); };
  std::vector<R> extremes;
  bool rises = slope(place(1)) > 0;
  for (int k = 2; k < points; ++k) {
    if ((slope(place(k)) > 0) == rises) continue;
    rises = !rises;
    std::uintmax_t steps = 100;
    const auto [low, high] =
        boost::math::tools::toms748_solve(slope, place(k - 1), place(k), boost::math::tools::eps_tolerance<R>(), steps);
    extremes.push_back((low + high) / 2);
  }
  return extremes;
}

}  // namespace steadyslide::proofs_checks
