#pragma once
// Conditions that Newton's method does not use: t <= 0 throughout the contact, no step of the profile in it, gap >= 0 throughout
// the rest.

#include <optional>
#include <vector>

#include "numeric/riemann_hilbert/traction_representation.hpp"

namespace steadyslide::numeric {

/// A stretch where an inequality fails.
template <Real R>
struct Violation {
  enum class What { tension, step, penetration } what;
  SurfacePoint<R> from;
  SurfacePoint<R> to;
  /// Tension: an anchor within the stretch whose leading term pulls. Step: its anchor.
  std::optional<std::size_t> anchor = std::nullopt;
  std::optional<R> log_reach = std::nullopt;  ///< how far the leading term pulls there (local_signs.hpp)
};

/// Left to right; what rounding alone, and the free ends' error, may have done is let pass. At ends and anchors the
/// leading term decides (local_signs.hpp); between them places are looked at, which proves nothing.
template <Real R>
std::vector<Violation<R>> violations(const TractionRepresentation<R>& form, const R& end_error = R(0));

}  // namespace steadyslide::numeric
