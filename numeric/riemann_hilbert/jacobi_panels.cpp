#include "numeric/riemann_hilbert/jacobi_panels.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::numeric {
namespace {

/// Returns the degree of Y at infinity, or the lowest degree of all Y_i.
template <Real R>
int lowest_degree(const SignedFundamentalSolution<R>& y) {
  int degree = y.degree_at_infinity();
  for (const auto& pivot : y.pivots()) degree = std::min(degree, pivot.order);
  return degree;
}

template <Real R>
int nodes_per_panel(const SignedFundamentalSolution<R>& y, SmoothFactor factor) {
  // Bernstein's ellipse through a pole at half a panel's length, or a branch point at one length, has a parameter of at
  // least 2 + sqrt 3. Each degree of the polynomial needs half a node more.
  if (factor == SmoothFactor::error) return 1;
  static const int geometric = static_cast<int>(-log(epsilon<R>()) / (2 * log(2 + sqrt(R(3))))) + 2;
  const int more = factor == SmoothFactor::regular_factor ? std::max(-lowest_degree(y), 0) : 0;
  return geometric + (y.problem().highest_degree() + 1) / 2 + more;
}

template <Real R>
bool is_singular(const SignedFundamentalSolution<R>& y, std::size_t j, SmoothFactor factor) {
  if (y.power(j).value != 0) return true;
  const ContactSet<R>& set = y.set();
  return factor != SmoothFactor::polynomial && j > 0 && j < set.segments() &&
         (set.in_contact(j) || set.in_contact(j - 1));
}

}  // namespace

template <Real R>
SurfacePoint<R> JacobiPanel<R>::node(const ContactSet<R>& set, std::size_t i) const {
  const bool mirrored = singular_end == Side::right;
  const R left = part.from_left + part.length * (mirrored ? rule->from_right[i] : rule->from_left[i]);
  const R right = part.from_right + part.length * (mirrored ? rule->from_left[i] : rule->from_right[i]);
  return surface_point(set, part.segment, left, right);
}

template <Real R>
R JacobiPanel<R>::node_weight(std::size_t i) const {
  const R w = part.length * rule->weights[i];
  return power.value == 0 ? w : w / pow(rule->from_left[i], power.value);
}

template <Real R>
std::vector<JacobiPanel<R>> jacobi_panels(const SignedFundamentalSolution<R>& y, const SegmentPart<R>& part,
                                          SmoothFactor factor, const std::function<Power<R>(std::size_t)>& power_at,
                                          JacobiRules<R>& rules) {
  // Panels are not longer than the segment, so they do not depend on points that are farther away.
  Surroundings<R> around = surroundings<R>(
      y.set(), part.segment, [&](std::size_t j) { return is_singular(y, j, factor); }, y.set().length(part.segment));
  if (part.from_left > 0) {
    around.beyond_left = around.left_singular ? part.from_left : part.from_left + around.beyond_left;
    around.left_singular = false;
  }
  if (part.from_right > 0) {
    around.beyond_right = around.right_singular ? part.from_right : part.from_right + around.beyond_right;
    around.right_singular = false;
  }
  const int nodes = nodes_per_panel(y, factor);
  std::vector<JacobiPanel<R>> result;
  for (const GradedPanel<R>& panel : graded_panels(part.length, around)) {
    Power<R> power;
    if (panel.singular_end) power = power_at(*panel.singular_end == Side::left ? part.segment : part.segment + 1);
    result.push_back(
        {{part.segment, part.from_left + panel.from_left, panel.length, part.from_right + panel.from_right},
         panel.singular_end,
         power,
         &rules.get(power, {}, nodes)});
  }
  return result;
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                               \
  template struct JacobiPanel<R>;                                                                                \
  template std::vector<JacobiPanel<R>> jacobi_panels(const SignedFundamentalSolution<R>&, const SegmentPart<R>&, \
                                                     SmoothFactor, const std::function<Power<R>(std::size_t)>&,  \
                                                     JacobiRules<R>&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
