#pragma once
// Integrals of products of powers over the stretch between two of their points e_first < e_last, in balls:
//
//   int prod_j |x - e_j|^(p_j) (c_0 + c_1 x + ... + c_m x^m) dx,   or with 1/(x - t) in it:
//
// Cauchy's integral for t outside [e_first, e_last], the principal value for t inside. By one of two routes that share no
// rule: Gauss-Jacobi panels (power_panel.hpp), or the trapezoidal rule (trapezoidal.hpp).
//
// Principal values on panels. Around t lies a panel [t-h, t+h] with a Gauss-Legendre rule of an even number of nodes. With G
// all that is integrated but 1/(x - t), int (G(x) - G(t))/(x - t) dx is the principal value, and by symmetry
// sum w_i G(t)/(x_i - t) = 0, so that the rule for it is sum w_i G(x_i)/(x_i - t). If |G| <= M in an ellipse with the
// half-height b across the axis, then |(G(z) - G(t))/(z - t)| <= 2 M/b on its boundary, and inside by the maximum principle.

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

/// The value, or why there is none: then it is not finite.
struct EnclosedIntegral {
  Ball value;
  std::string refusal;
};

/// From points[first] to points[last], at the rules' precision; the trapezoidal route uses nothing else of the rules.
/// Refuses, in words: numbers that are not finite, points that are not certainly in order, powers in the stretch that are not
/// certainly above -1, a pole that is not certainly away from every point of the stretch. Throws std::invalid_argument unless
/// first < last < points.size() == powers.size().
EnclosedIntegral enclosed_integral(const PowerIntegrand& integrand, std::size_t first, std::size_t last, Route route,
                                   JacobiRules& rules);

}  // namespace steadyslide::enclosure
