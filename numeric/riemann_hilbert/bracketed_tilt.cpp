#include "numeric/riemann_hilbert/bracketed_tilt.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace steadyslide::numeric {
namespace {

/// Thrown inside the algorithm of Boost, which has no other way to stop.
struct NotSolved {};

}  // namespace

std::optional<double> bracketed_tilt(const std::function<std::optional<double>(double tilt)>& offset, double start,
                                     double step) {
  constexpr int most_doublings = 60;
  struct Place {
    double tilt;
    double offset;
  };
  std::optional<Place> low, high;  // the offset is positive at the lower end and negative at the higher one
  const auto visit = [&](double tilt) {
    const std::optional<double> there = offset(tilt);
    if (!there) return;
    if (*there >= 0 && (!low || tilt > low->tilt)) low = {tilt, *there};
    if (*there <= 0 && (!high || tilt < high->tilt)) high = {tilt, *there};
  };
  visit(start);
  for (int k = 0; k < most_doublings && (!low || !high); ++k) {
    if (!high) visit(start + std::ldexp(step, k));
    if (!low) visit(start - std::ldexp(step, k));
  }
  if (!low || !high) return std::nullopt;
  if (low->tilt >= high->tilt) return low->tilt;
  const auto value = [&offset](double tilt) {
    const std::optional<double> there = offset(tilt);
    if (!there) throw NotSolved();
    return *there;
  };
  try {
    std::uintmax_t most_steps = 60;
    const auto [from, to] =
        boost::math::tools::toms748_solve(value, low->tilt, high->tilt, low->offset, high->offset,
                                          boost::math::tools::eps_tolerance<double>(48), most_steps);
    return (from + to) / 2;
  } catch (const NotSolved&) {
    return std::nullopt;
  }
}

}  // namespace steadyslide::numeric
