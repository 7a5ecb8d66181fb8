#include "numeric/riemann_hilbert/bracketed_tilt.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

namespace steadyslide::numeric {
namespace {

/// Thrown inside the algorithm of Boost, which has no other way to stop.
struct NotSolved {};

}  // namespace

std::optional<double> bracketed_tilt(const std::function<std::optional<double>(double tilt)>& offset, double start,
                                     double step) {
  constexpr int most_doublings = 60;
  const auto value = [&offset](double tilt) {
    const std::optional<double> there = offset(tilt);
    if (!there) throw NotSolved();
    return *there;
  };
  try {
    double near = start, value_near = value(near);
    // A centre too far to the right needs a larger tilt.
    const double outwards = value_near > 0 ? step : -step;
    double far = near + outwards, value_far = value(far);
    for (int k = 0; k < most_doublings && value_far * value_near > 0; ++k) {
      near = far;
      value_near = value_far;
      far = start + std::ldexp(outwards, k + 1);
      value_far = value(far);
    }
    if (value_near == 0) return near;
    if (value_far * value_near > 0) return std::nullopt;
    if (far < near) {
      std::swap(near, far);
      std::swap(value_near, value_far);
    }
    std::uintmax_t most_steps = 60;
    const auto [low, high] = boost::math::tools::toms748_solve(
        value, near, far, value_near, value_far, boost::math::tools::eps_tolerance<double>(48), most_steps);
    return (low + high) / 2;
  } catch (const NotSolved&) {
    return std::nullopt;
  }
}

}  // namespace steadyslide::numeric
