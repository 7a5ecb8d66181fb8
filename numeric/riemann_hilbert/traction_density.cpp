#include "numeric/riemann_hilbert/traction_density.hpp"

#include <cmath>

namespace steadyslide::numeric {
namespace {

template <Real R>
Power<R> traction_power(const TractionRepresentation<R>& form, std::size_t j) {
  const Power<R>& p = form.power(j);
  if (form.changes_polynomial(j) && p.value > 0 && form.set().anchor_at(j)->exact.wedge != 0) return {};
  return p;
}

}  // namespace

template <Real R>
PanelDensity<R> panel_density(const TractionRepresentation<R>& form, std::size_t segment) {
  const Power<R> left = traction_power(form, segment);
  const Power<R> right = traction_power(form, segment + 1);
  const R factor = form.y().traction_factor(segment);
  const R& p_left = form.power(segment).value;
  const R& p_right = form.power(segment + 1).value;
  const bool left_is_smooth = p_left != left.value;
  const bool right_is_smooth = p_right != right.value;
  const auto smooth = [&form, &p_left, &p_right, segment, factor, left_is_smooth,
                       right_is_smooth](const Node<R>& node) {
    const SurfacePoint<R> at{static_cast<std::ptrdiff_t>(segment), node};
    R value = factor * form.y().smooth_modulus(segment, node) * form.regular_value(form.slope_at(segment), at);
    if (left_is_smooth) value *= pow(node.from_left, p_left);
    if (right_is_smooth) value *= pow(node.from_right, p_right);
    return value;
  };
  const ContactSet<R>& set = form.set();
  PanelDensity<R> density{set.panel(segment), left, right, smooth, R(0)};
  for (std::size_t k = segment; k-- > 0 && !set.in_contact(k);) density.gap += set.length(k);
  return density;
}

template <Real R>
PiecewiseDensity<R> traction_density(const TractionRepresentation<R>& form) {
  PiecewiseDensity<R> result;
  const std::vector<std::size_t>& segments = form.set().contact_segments();
  for (const std::size_t k : segments) result.push_back(panel_density(form, k));
  if (!result.empty()) result.front().gap = 0;
  // The only singular points are the ends of the only panel.
  if (result.size() == 1) result.front().is_constant = form.regular_value_is_constant(form.slope_at(segments.front()));
  return result;
}

#define STEADYSLIDE_INSTANTIATE(R)                                                       \
  template PanelDensity<R> panel_density(const TractionRepresentation<R>&, std::size_t); \
  template PiecewiseDensity<R> traction_density(const TractionRepresentation<R>&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
