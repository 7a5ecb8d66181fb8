#pragma once
// The conditions that Newton's method does not use: t <= 0 everywhere in the contact, no step of the profile in the
// contact, gap >= 0 everywhere else.

#include <optional>
#include <vector>

#include "numeric/riemann_hilbert/traction_representation.hpp"

namespace steadyslide::numeric {

/// An interval where an inequality fails.
template <Real R>
struct Violation {
  enum class What { tension, step, penetration } what;
  SurfacePoint<R> from;
  SurfacePoint<R> to;
  /// For tension: an anchor in the interval whose leading term is tension. For a step: its anchor.
  std::optional<std::size_t> anchor = std::nullopt;
  std::optional<R> log_reach = std::nullopt;  ///< the length over which the leading term is tension (local_signs.hpp)
};

/// Returns the failures from left to right. Failures within the rounding error and the error of the free ends are
/// accepted. At ends and anchors the leading term decides (local_signs.hpp). Between them only sampled places are
/// checked, which is not a proof.
template <Real R>
std::vector<Violation<R>> violations(const TractionRepresentation<R>& form, const R& end_error = R(0));

}  // namespace steadyslide::numeric
