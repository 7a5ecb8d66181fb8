#include "numeric/interior/largest_stress.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace steadyslide::numeric {
namespace {

template <Real R>
struct StressPoint {
  R x;
  R z;
  R value;
  R scale;          ///< length scale of the field; for a maximum, the error of its position
  R curvature = 0;  ///< for a maximum: the smallest curvature of the stress times its length of variation
};

template <Real R>
Estimate<R> von_mises_at(const StressField<R>& stress, const R& x, const R& z) {
  StressState<R> state;
  stress.at(std::span(&x, 1), std::span(&z, 1), std::span(&state, 1));
  return *state.von_mises();
}

template <Real R>
class Maximum {
 public:
  Maximum(const StressField<R>& stress, const R& least_depth) : stress_(stress), least_(least_depth) {}

  /// Returns all maxima that are reached from the highest scanned places, the highest one first.
  std::vector<StressPoint<R>> highest() const {
    std::vector<StressPoint<R>> places = scan();
    std::sort(places.begin(), places.end(),
              [](const StressPoint<R>& a, const StressPoint<R>& b) { return a.value > b.value; });
    std::vector<StressPoint<R>> starts;
    for (const StressPoint<R>& place : places) {
      constexpr std::size_t most = 6;
      const auto is_near = [&](const StressPoint<R>& start) {
        return abs(start.x - place.x) + abs(start.z - place.z) < std::max(place.scale, start.scale) / 2;
      };
      if (std::none_of(starts.begin(), starts.end(), is_near)) starts.push_back(place);
      if (starts.size() == most) break;
    }
    std::transform(starts.begin(), starts.end(), starts.begin(),
                   [this](const StressPoint<R>& start) { return climbed(start); });
    std::stable_sort(starts.begin(), starts.end(),
                     [](const StressPoint<R>& a, const StressPoint<R>& b) { return a.value > b.value; });
    return starts;
  }

 private:
  StressPoint<R> scanned(const R& x, const R& z, const R& scale) const {
    const R depth = std::max(z, least_);
    return {x, depth, stress_.on_finest_mesh(x, depth).von_mises()->value, scale};
  }

  std::vector<StressPoint<R>> scan() const {
    std::vector<StressPoint<R>> places;
    const std::vector<TractionPanel<R>>& panels = stress_.traction().panels();
    const R width = stress_.traction().width();
    // An average varies over the length of its window, except beside the places where the window ends at a singular point.
    const R shortest = std::max(R(width / 16384), R(stress_.window() / 8));
    // Groups of 1, 2, 4, ... panels, and the group of all panels.
    for (std::size_t count = 1;; count *= 2) {
      for (std::size_t k = 0; k < panels.size(); k += count) {
        const std::size_t end = std::min(k + count, panels.size());
        const R length = panels[end - 1].right - panels[k].left;
        if (count < panels.size() && length < std::max(shortest, R(least_ / 4))) continue;
        for (int i = -1; i <= 5; ++i) {
          const R x = panels[k].left.high + length * i / 4;
          for (const R& z : {R(0), R(length / 4), R(length / 2), length}) places.push_back(scanned(x, z, length));
        }
      }
      if (count >= panels.size()) break;
    }
    for (const double interface : stress_.interfaces()) {
      const R depth = interface, step = std::max(R(width / 64), R(depth / 8));
      for (R x = panels.front().left.high - 2 * depth; x < panels.back().right.high + 2 * depth; x += step) {
        for (const R& side : {depth, R(depth * (1 + 4 * epsilon<R>()))}) places.push_back(scanned(x, side, depth / 8));
      }
    }
    for (const TractionPanel<R>& panel : panels) {
      if (!panel.singular_end) continue;
      const R end = *panel.singular_end == Side::left ? panel.left.high : panel.right.high;
      const R half = stress_.window() / 2;
      for (int i = half > 0 ? -1 : 0; i <= (half > 0 ? 1 : 0); ++i) add_beside(end + i * half, panel.length, places);
    }
    return places;
  }

  /// Adds places towards the end x of a panel. A power near 0 may have its maximum at any scale that the digits of x
  /// resolve.
  void add_beside(const R& x, const R& length, std::vector<StressPoint<R>>& places) const {
    const R shortest = std::max(least_, R(64 * epsilon<R>() * abs(x)));
    places.push_back(scanned(x, R(0), length / 8));
    const int finer = stress_.window() > 0 ? 16 : 4;
    for (R scale = length / 8; scale > shortest; scale /= finer) {
      for (int i = -1; i <= 1; ++i) places.push_back(scanned(x + i * scale, scale, scale));
      for (const int i : {-1, 1}) places.push_back(scanned(x + i * scale, R(0), scale));
    }
  }

  /// Returns the maximum nearest to `start`; its stress is never lower than at `start`. `scale` is the error of its
  /// position.
  StressPoint<R> climbed(const StressPoint<R>& start) const {
    StressPoint<R> at = start;
    R h = std::min(at.scale, max(at.z, R(at.scale / 8))) / 8;
    // With smaller differences, rounding would be a larger error than the cubic terms are here.
    const R smallest = pow(epsilon<R>(), R(0.25)) * at.scale;
    const R last = epsilon<R>() * at.scale;
    const R scale = at.scale;
    // The length on which the field varies.
    const R variation = std::min(scale, max(at.z, R(scale / 8)));
    for (int step = 0; step < 400 && h > last; ++step) {
      const Stencil here = stencil(at, h);
      if (here.is_peak) {
        const StressPoint<R> peak = scanned(at.x + here.x_step, at.z + here.z_step, scale);
        if (h <= smallest && peak.value >= at.value * (1 - 64 * epsilon<R>())) {
          return {peak.x, peak.z, peak.value, 4 * h * h / scale, here.curvature / (h * h) * variation};
        }
        const R moved = max(abs(here.x_step), abs(here.z_step));
        at = peak.value >= here.highest.value ? peak : here.highest;
        h = max(smallest, std::min(R(h / 4), max(moved, R(h / 64))));
      } else if (here.highest.value > at.value) {
        at = here.highest;
        h = std::min(R(2 * h), R(scale / 8));
      } else {
        h /= 4;
      }
    }
    at.scale = h;
    return at;
  }

  struct Stencil {
    StressPoint<R> highest;
    bool is_peak;  ///< the fitted parabola has its maximum inside the stencil
    R x_step;
    R z_step;
    R curvature = 0;  ///< the smallest curvature, times the square of the stencil's step
  };

  Stencil stencil(const StressPoint<R>& at, const R& h) const {
    R f[3][3];  // along x, along z
    Stencil result{at, false, R(0), R(0)};
    const bool at_surface = at.z - h < least_;
    const R z = at_surface ? least_ : at.z;
    for (int i = -1; i <= 1; ++i) {
      for (int j = at_surface ? 0 : -1; j <= 1; ++j) {
        const StressPoint<R> there = scanned(at.x + i * h, z + j * h, at.scale);
        f[i + 1][j + 1] = there.value;
        if (there.value > result.highest.value) result.highest = there;
      }
    }
    const R xx = f[2][1] - 2 * f[1][1] + f[0][1];
    const R x = (f[2][1] - f[0][1]) / 2;
    if (at_surface) {
      // The maximum is at this depth if the stress decreases with the depth.
      if (!(f[1][2] < f[1][1] && xx < 0)) return result;
      result.x_step = -h * x / xx;
      result.z_step = z - at.z;
      result.is_peak = abs(x) <= abs(xx);
      result.curvature = -xx;
      return result;
    }
    const R zz = f[1][2] - 2 * f[1][1] + f[1][0];
    const R zd = (f[1][2] - f[1][0]) / 2;
    const R xz = (f[2][2] - f[2][0] - f[0][2] + f[0][0]) / 4;
    const R determinant = xx * zz - xz * xz;
    if (!(xx < 0 && determinant > 0)) return result;
    result.x_step = -h * (zz * x - xz * zd) / determinant;
    result.z_step = -h * (xx * zd - xz * x) / determinant;
    result.is_peak = abs(result.x_step) <= h && abs(result.z_step) <= h;
    result.curvature = 2 * determinant / (sqrt((xx - zz) * (xx - zz) + 4 * xz * xz) - xx - zz);
    return result;
  }

  const StressField<R>& stress_;
  R least_;
};

}  // namespace

template <Real R>
std::vector<Estimate<R>> unbounded_places(const ContactSolution<R>& solution) {
  std::vector<Estimate<R>> result;
  for (const SolvedSingularPoint<R>& point : solution.singular_points()) {
    const LocalTerms& terms = local_terms(point.kind);
    // At a constant beside a friction jump the shear jumps.
    if (terms.is_infinite(point.exponent) || (terms.friction_jumps && terms.has_constant)) result.push_back(point.x);
  }
  return result;
}

template <Real R>
R default_depth(const ContactSolution<R>& solution) {
  const std::vector<ContactComponent<R>> contact = solution.contact();
  const auto jumps = [](const SolvedSingularPoint<R>& point) { return point.kind == SingularKind::friction_jump; };
  const std::vector<SolvedSingularPoint<R>> points = solution.singular_points();
  const bool is_bounded = unbounded_places(solution).empty() && std::none_of(points.begin(), points.end(), jumps);
  if (contact.empty() || is_bounded) return 0;
  return (contact.back().right.x.value - contact.front().left.x.value) / 100;
}

template <Real R>
std::optional<LargestStress<R>> largest_stress(const StressField<R>& stress, const R& depth) {
  if (!(depth >= 0)) throw std::invalid_argument("depth");
  const std::vector<TractionPanel<R>>& panels = stress.traction().panels();
  if (!stress.traction().elasticity().half_space() || panels.empty()) return std::nullopt;
  const R width = stress.traction().width();
  // At the ends of cells the stress of constant shears has a logarithm, so depths below half a cell are left out.
  const bool on_cells = panels.front().count == 1 && stress.window() == 0;
  const R least = std::max(depth, on_cells ? R(panels.front().length / 2) : R(width * R(1e-30)));
  const std::vector<StressPoint<R>> maxima = Maximum<R>(stress, least).highest();
  const StressPoint<R>& best = maxima.front();
  Estimate<R> von_mises = von_mises_at(stress, best.x, best.z);
  if (on_cells && best.z == least && depth < least)
    von_mises.error += abs(von_mises.value - von_mises_at(stress, best.x, R(2 * least)).value);
  // The error of the stress varies on the same length as the stress, so its slope moves the maximum.
  const R moved = best.curvature > 0 ? R(von_mises.error / best.curvature) : R(0);
  Estimate<R> x{best.x, best.scale + moved + epsilon<R>() * abs(best.x)};
  Estimate<R> z{best.z, best.z == least ? R(0) : x.error};
  if (best.z == least) z.value = depth;
  // Another maximum may be the largest one. If both are equal, the place is one of them.
  for (const StressPoint<R>& other : maxima) {
    const R less = best.value - other.value;
    if (less <= 256 * epsilon<R>() * best.value || less > 2 * von_mises.error) continue;
    x.error = std::max(x.error, R(abs(other.x - best.x)));
    z.error = std::max(z.error, R(abs(other.z - best.z)));
  }
  x.error = std::min(x.error, width);
  return LargestStress<R>{depth, von_mises, x, z};
}

#define STEADYSLIDE_INSTANTIATE(R)                                               \
  template std::vector<Estimate<R>> unbounded_places(const ContactSolution<R>&); \
  template R default_depth(const ContactSolution<R>&);                           \
  template std::optional<LargestStress<R>> largest_stress(const StressField<R>&, const R&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
