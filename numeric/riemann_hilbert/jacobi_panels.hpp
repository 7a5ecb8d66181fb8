#pragma once
// Gauss-Jacobi rules for integrals over a part of a segment, graded towards all singular points around it.

#include <functional>
#include <optional>
#include <vector>

#include "numeric/quadrature/graded_panels.hpp"
#include "numeric/quadrature/jacobi_rule.hpp"
#include "numeric/riemann_hilbert/signed_fundamental_solution.hpp"

namespace steadyslide::numeric {

/// A part of a segment: the length on its left, its own length, and the length on its right. Zeros are exact.
template <Real R>
struct SegmentPart {
  std::size_t segment;
  R from_left;
  R length;
  R from_right;
};

template <Real R>
SegmentPart<R> whole_segment(const ContactSet<R>& set, std::size_t segment) {
  return {segment, R(0), set.length(segment), R(0)};
}

/// Returns the singular points at the ends of a segment and up to the distance `reach` beyond them. is_singular(j) is true
/// for a singular point j.
template <Real R, class IsSingular>
Surroundings<R> surroundings(const ContactSet<R>& set, std::size_t segment, const IsSingular& is_singular,
                             const R& reach = infinity<R>()) {
  Surroundings<R> result{is_singular(segment), is_singular(segment + 1), infinity<R>(), infinity<R>()};
  R distance = 0;
  for (std::size_t j = segment; j-- > 0 && distance < reach;) {
    distance += set.length(j);
    if (!is_singular(j)) continue;
    result.beyond_left = distance;
    break;
  }
  distance = 0;
  for (std::size_t j = segment + 2; j < set.points().size() && distance < reach; ++j) {
    distance += set.length(j - 1);
    if (!is_singular(j)) continue;
    result.beyond_right = distance;
    break;
  }
  return result;
}

/// One rule. Its nodes are numbered from the end with the power.
template <Real R>
struct JacobiPanel {
  SegmentPart<R> part;
  std::optional<Side> singular_end;
  Power<R> power;
  const UnitRule<R>* rule;

  SurfacePoint<R> node(const ContactSet<R>& set, std::size_t i) const;
  /// Returns the weight in int f dxi = sum of node_weight(i) f(node(i)), for f = distance^power times a smooth
  /// function.
  R node_weight(std::size_t i) const;
};

/// The factor of the powers of distances: a polynomial; or B_k, whose degree is higher by -S and which is also singular
/// where contact begins, ends or changes its polynomial; or an error of B_k, which is needed only in order of
/// magnitude, with one node for each panel.
enum class SmoothFactor { polynomial, regular_factor, error };

/// Returns the panels. `power_at(j)` is the integrand's power at point j. `rules` must outlive the panels.
template <Real R>
std::vector<JacobiPanel<R>> jacobi_panels(const SignedFundamentalSolution<R>& y, const SegmentPart<R>& part,
                                          SmoothFactor factor, const std::function<Power<R>(std::size_t)>& power_at,
                                          JacobiRules<R>& rules);

}  // namespace steadyslide::numeric
