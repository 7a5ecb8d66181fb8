#pragma once
// Checks if a traction satisfies the contact problem, in reduced quantities and by quadrature rules that no solver
// uses: in higher precision than double the double-exponential grid where it is suitable, otherwise the trapezoidal
// grid.

#include <algorithm>
#include <array>
#include <optional>
#include <variant>

#include "numeric/cauchy/sliding_operator.hpp"
#include "numeric/number/once.hpp"
#include "numeric/quadrature/double_exponential_grid.hpp"

namespace steadyslide::numeric {

/// The points at which a gap is checked, as fractions of its length: Chebyshev's points in double.
template <Real R>
std::array<R, 8> gap_places() {
  std::array<R, 8> result;
  for (int i = 0; i < 8; ++i) result[static_cast<std::size_t>(i)] = chebyshev_position<double>(i, 8).first;
  return result;
}

template <Real R>
class SurfaceCheck {
 public:
  using ProfileSlope = std::function<R(std::size_t panel, const Node<R>&)>;

  /// Takes t panel by panel, s on each panel, and psi'/c with the indenter's tilt.
  SurfaceCheck(PiecewiseDensity<R> traction, std::vector<R> s, ProfileSlope profile_slope)
      : density_(std::move(traction)), s_(std::move(s)), profile_slope_(std::move(profile_slope)) {
    if constexpr (!std::same_as<R, double>) {
      if (double_exponential::Grid<R>::suits(density_)) short_grid_.emplace(density_);
    }
  }

  /// Returns int t.
  R integral() const {
    if constexpr (!std::same_as<R, double>) {
      if (short_grid_) return short_grid_->integral();
    }
    return grid().integral();
  }
  /// Returns int t over panel k; absent in higher precision than double if the short grid is not suitable.
  std::optional<Estimate<R>> panel_integral(std::size_t k) const {
    if constexpr (std::same_as<R, double>) {
      return Estimate<R>{grid().panel_integral(k), R(0)}.widened(16 * epsilon<R>());
    } else {
      if (short_grid_) return short_grid_->panel_integral(k);
      return std::nullopt;
    }
  }
  /// Returns the largest relative residual of A t = psi'/c (sliding_operator.hpp) over points of every panel, from 1e-6
  /// of its length from one end to 1e-6 from the other. The short grid has two or three points in a panel, not next to
  /// the ends.
  R equation() const {
    R worst = 0;
    for_points([&](const auto& grid, const auto& point) {
      const R t = density_[point.panel](point.node);
      const SlidingTerms<R> terms{t, {grid.hilbert(point)}, s_[point.panel] * t};
      worst = std::max(worst, terms.residual(profile_slope_(point.panel, point.node)));
    });
    return worst;
  }
  /// Returns the largest t at those points; for the short grid, at all its nodes at least 1e-6 of the length from both
  /// ends.
  R highest_traction() const {
    if constexpr (!std::same_as<R, double>) {
      if (short_grid_) return short_grid_->highest();
    }
    R highest = -infinity<R>();
    for_points([&](const auto&, const PanelPoint<R>& point) {
      highest = std::max(highest, density_[point.panel](point.node));
    });
    return highest;
  }
  /// Returns u/c at the distance d beyond the end of panel k, where a gap begins, minus u/c at that end.
  R displacement(std::size_t k, Side end, const R& distance) const { return grid().displacement(k, end, distance); }
  /// Returns by how much the surface lies above a profile that rises by `rise` from that end; 0 if the gap is open.
  /// Higher precision than double is used only if double cannot distinguish the gap from 0.
  R penetration(std::size_t k, Side end, const R& distance, const R& rise) const {
    if constexpr (!std::same_as<R, double>) {
      const auto profile = static_cast<double>(rise);
      const Estimate<double> surface = short_grid_
                                           ? short_grid_->rough_displacement(k, end, static_cast<double>(distance))
                                           : Estimate<double>{0, infinity<double>()};
      if (profile - surface.value > surface.error + 1e-15 * abs(profile)) return 0;
    }
    return std::max(R(displacement(k, end, distance) - rise), R(0));
  }

 private:
  /// Returns the trapezoidal grid, which is computed at first use.
  const trapezoidal::Grid<R>& grid() const {
    return grid_([this] { return trapezoidal::Grid<R>(density_); });
  }

  template <class Visit>
  void for_points(const Visit& visit) const {
    if constexpr (!std::same_as<R, double>) {
      if (short_grid_) {
        using namespace double_exponential;
        for (std::size_t k = 0; k < density_.size(); ++k) {
          const auto nearest = [&](Side side) {
            return short_grid_->touches(k, side) ? nearest_beside_a_panel : nearest_place;
          };
          std::vector<double> places{nearest(Side::left), 1 - nearest(Side::right)};
          if (density_.size() <= 4) places.push_back(0.5625);
          for (const double place : places) visit(*short_grid_, short_grid_->midpoint_near(k, place));
        }
        return;
      }
    }
    // Numerators over 10^6, which are exact at every precision.
    constexpr int denominator = 1'000'000;
    for (std::size_t k = 0; k < density_.size(); ++k) {
      for (const int place : {1, 100, 10'000, 250'000, 500'000, 800'000, 990'000, 999'900, 999'999}) {
        visit(grid(), grid().midpoint_near(k, R(place) / denominator));
      }
    }
  }

  PiecewiseDensity<R> density_;
  std::vector<R> s_;
  ProfileSlope profile_slope_;
  using ShortGrid = std::conditional_t<std::same_as<R, double>, std::monostate, double_exponential::Grid<R>>;
  std::optional<ShortGrid> short_grid_;
  Once<trapezoidal::Grid<R>> grid_;
};

}  // namespace steadyslide::numeric
