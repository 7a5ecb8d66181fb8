#include "numeric/interior/interior_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace steadyslide::numeric {

template <Real R>
InteriorDisplacement<R>::InteriorDisplacement(PiecewiseTraction<R> traction, const Rational& origin)
    : traction_(std::move(traction)) {
  const Elasticity& elasticity = traction_.elasticity();
  if (!elasticity.half_space()) throw std::invalid_argument("a displacement needs elastic constants");
  const Rational kolosov = elasticity.half_space()->kolosov(elasticity.plane());
  half_sum_ = to_real<R>((kolosov + 1) / 2);
  half_difference_ = to_real<R>((kolosov - 1) / 2);
  scale_ = 1 / (2 * pi<R>() * to_real<R>(elasticity.half_space()->shear_modulus()));
  const auto& panels = traction_.panels();
  if (!panels.empty()) width_ = panels.back().right - panels.front().left;
  at_origin_ = unscaled(origin, 0);
}

template <Real R>
std::pair<R, R> InteriorDisplacement<R>::of_force(const R& ratio, const R& x, const R& z) const {
  using std::atan2;
  const R over = x / width_, under = z / width_;
  const R square = over * over + under * under;
  const R mixed = over * under / square, part = under * under / square;
  const R turned = half_difference_ * atan2(over, under);
  const R logarithm = half_sum_ / 2 * log(square);
  return {turned - mixed - ratio * (logarithm + part), logarithm - part + ratio * (mixed + turned)};
}

template <Real R>
void InteriorDisplacement<R>::add_part(const TractionPanel<R>& panel, const PanelPart<R>& part, const R& x_left,
                                       const R& x_right, const R& z, Displacement<R>& sum) const {
  TractionNodes<R> nodes;
  traction_.append_nodes(panel, part, nodes);
  const R& from_end = panel.singular_end == Side::right ? x_right : x_left;
  const R reach = sqrt(from_end * from_end + z * z);
  const R unresolved = epsilon<R>() * epsilon<R>() * panel.length;
  // Distances to x are sums that start at the end of the part next to x.
  const bool by_left = x_left <= 0;
  Displacement<R> displaced;
  for (std::size_t i = 0; i < nodes.forces.size(); ++i) {
    const R &left = nodes.from_left[i], &right = nodes.from_right[i], &force = nodes.forces[i];
    const R x = by_left ? x_left - left : x_right + right;
    const auto [along, down] = of_force(panel.shear_ratio, x, z);
    const R error = abs(force) * (panel.error + 4 * epsilon<R>());
    sum.x += Estimate<R>{force * along, error * abs(along)};
    sum.z += Estimate<R>{force * down, error * abs(down)};
    // The logarithm is not graded further.
    if (abs(x) + z <= unresolved) {
      const R rest = half_sum_ * abs(force);
      sum.x.error += abs(panel.shear_ratio) * rest;
      sum.z.error += rest;
    }
    if (panel.end_error == 0) continue;
    const R change = force * panel.displaced(part, left, right, reach);
    displaced.x.value += change * along;
    displaced.z.value += change * down;
  }
  sum.x.error += abs(displaced.x.value);
  sum.z.error += abs(displaced.z.value);
}

template <Real R>
void InteriorDisplacement<R>::add_panel(const TractionPanel<R>& panel, const R& x_left, const R& x_right, const R& z,
                                        Displacement<R>& sum) const {
  const R &length = panel.length, zero = 0;
  const R aside = std::max({R(-x_left), x_right, zero});
  const R distance = sqrt(aside * aside + z * z);
  if (distance < length) {
    const R nearest = std::max(z, R(epsilon<R>() * epsilon<R>() * length));
    if (x_left > 0 && x_right < 0) {
      add_part(panel, {zero, x_left, -x_right, infinity<R>(), nearest}, x_left, zero, z, sum);
      add_part(panel, {x_left, -x_right, zero, nearest, infinity<R>()}, zero, x_right, z, sum);
      return;
    }
    PanelPart<R> whole{zero, length, zero};
    (x_left <= 0 ? whole.beyond_left : whole.beyond_right) = std::max(distance, nearest);
    add_part(panel, whole, x_left, x_right, z, sum);
    return;
  }
  TractionNodes<R> nodes;
  traction_.append_nodes(panel, nodes);
  const R steepness = (half_sum_ + half_difference_ + 1) * (1 + abs(panel.shear_ratio)) / distance;
  for (std::size_t i = 0; i < nodes.forces.size(); ++i) {
    const R& force = nodes.forces[i];
    const auto [along, down] = of_force(panel.shear_ratio, R(x_left - nodes.from_left[i]), z);
    const R error = abs(force) * (panel.force_error + 4 * epsilon<R>()), moved = abs(force) * panel.shift * steepness;
    sum.x += Estimate<R>{force * along, error * abs(along) + moved};
    sum.z += Estimate<R>{force * down, error * abs(down) + moved};
  }
}

template <Real R>
Displacement<R> InteriorDisplacement<R>::unscaled(const Rational& x, const Rational& z) const {
  const SurfacePlace<R> place = SurfacePlace<R>::of(x);
  Displacement<R> sum;
  for (const TractionPanel<R>& panel : traction_.panels()) {
    add_panel(panel, place - panel.left, place - panel.right, to_real<R>(z), sum);
  }
  return sum;
}

template <Real R>
Displacement<R> InteriorDisplacement<R>::at(const Rational& x, const Rational& z) const {
  if (z < 0) throw std::invalid_argument("the depth of a point in the body is at least 0");
  const Displacement<R> there = unscaled(x, z);
  return {scale_ * (there.x - at_origin_.x), scale_ * (there.z - at_origin_.z)};
}

STEADYSLIDE_INSTANTIATE_CLASS(InteriorDisplacement)

}  // namespace steadyslide::numeric
