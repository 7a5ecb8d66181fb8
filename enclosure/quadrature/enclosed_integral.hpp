#pragma once
// Integrals of products of powers over the interval between two of their points e_first < e_last, in balls:
//
//   int prod_j |x - e_j|^(p_j) (c_0 + c_1 x + ... + c_m x^m) dx,   or the same with the factor 1/(x - t):
//
// Cauchy's integral for t outside [e_first, e_last], the principal value for t inside. There are two independent
// routes: Gauss-Jacobi panels (power_panel.hpp), and the trapezoidal rule (trapezoidal.hpp).
//
// Principal values on panels. Around t there is a panel [t-h, t+h] with a Gauss-Legendre rule of an even number of
// nodes. Let G be the integrand without 1/(x - t). Then int (G(x) - G(t))/(x - t) dx is the principal value, and by
// symmetry sum w_i G(t)/(x_i - t) = 0, so its rule is sum w_i G(x_i)/(x_i - t). If |G| <= M in an ellipse with the
// half-height b across the axis, then |(G(z) - G(t))/(z - t)| <= 2 M/b on its boundary, and inside by the maximum
// principle.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "enclosure/number/ball.hpp"
#include "enclosure/quadrature/jacobi_rule.hpp"

namespace steadyslide::enclosure {

struct PowerIntegrand {
  std::vector<Ball> points;  ///< e_j, increasing
  std::vector<Ball> powers;  ///< p_j
  std::vector<Ball> polynomial{Ball(1)};
  std::optional<Ball> pole = std::nullopt;  ///< t
};

enum class Route { panels, trapezoidal };

/// The value, or the reason why there is none; then the value is not finite.
struct EnclosedIntegral {
  Ball value;
  std::string refusal;
};

/// Integrates from points[first] to points[last], at the rules' precision; the trapezoidal route uses nothing else of
/// the rules. Returns a reason instead of a value for: numbers that are not finite, points that are not certainly in
/// order, powers in the interval that are not certainly above -1, a pole that is not certainly separate from every
/// point of the interval. Throws std::invalid_argument unless first < last < points.size() == powers.size().
EnclosedIntegral enclosed_integral(const PowerIntegrand& integrand, std::size_t first, std::size_t last, Route route,
                                   JacobiRules& rules);

}  // namespace steadyslide::enclosure
