#include "numeric/cauchy/residuals.hpp"

#include <algorithm>
#include <array>

#include "numeric/cauchy/sliding_operator.hpp"

namespace steadyslide::numeric {

template <Real R>
SurfaceCheck<R>::SurfaceCheck(PiecewiseDensity<R> traction, std::vector<R> s, ProfileSlope profile_slope)
    : grid_(std::move(traction)), s_(std::move(s)), profile_slope_(std::move(profile_slope)) {}

template <Real R>
std::vector<PanelPoint<R>> SurfaceCheck<R>::points() const {
  // Numerators over 10^6: exact at every precision.
  constexpr std::array<int, 9> fractions{1, 100, 10'000, 250'000, 500'000, 800'000, 990'000, 999'900, 999'999};
  std::vector<PanelPoint<R>> result;
  for (std::size_t k = 0; k < grid_.density().size(); ++k) {
    for (const int fraction : fractions) result.push_back(grid_.midpoint_near(k, R(fraction) / 1'000'000));
  }
  return result;
}

template <Real R>
R SurfaceCheck<R>::equation() const {
  const SlidingOperator<R> A(grid_, s_);
  R worst = 0;
  for (const PanelPoint<R>& point : points()) {
    worst = std::max(worst, A.at(point).residual(profile_slope_(point.panel, point.node)));
  }
  return worst;
}

template <Real R>
R SurfaceCheck<R>::highest_traction() const {
  R highest = -infinity<R>();
  for (const PanelPoint<R>& point : points()) {
    highest = std::max(highest, grid_.density()[point.panel](point.node));
  }
  return highest;
}

template class SurfaceCheck<double>;
template class SurfaceCheck<Real50>;
template class SurfaceCheck<Real100>;

}  // namespace steadyslide::numeric
