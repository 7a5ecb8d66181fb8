#include "enclosure/quadrature/enclosed_integral.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "enclosure/number/ball_polynomial.hpp"
#include "enclosure/quadrature/graded_panels.hpp"
#include "enclosure/quadrature/power_panel.hpp"
#include "enclosure/quadrature/trapezoidal.hpp"

namespace steadyslide::enclosure {
namespace {

/// The interval between two neighbouring points, with the data for panels.
struct Piece {
  Ball start;  ///< x of its left end
  Ball length;
  Ball left;
  Ball right;
  std::vector<OutsidePoint> outside;
};

Piece piece_between(const PowerIntegrand& integrand, std::size_t k) {
  const std::vector<Ball>&e = integrand.points, &p = integrand.powers;
  Piece piece{e[k], e[k + 1] - e[k], p[k], p[k + 1], {}};
  for (std::size_t j = 0; j < e.size(); ++j) {
    if (j < k) piece.outside.push_back({Side::left, e[k] - e[j], p[j]});
    if (j > k + 1) piece.outside.push_back({Side::right, e[j] - e[k + 1], p[j]});
  }
  return piece;
}

/// The factor of the integrand on a piece that is not a power: a polynomial and a sign.
class PieceIntegral {
 public:
  PieceIntegral(const PowerIntegrand& integrand, JacobiRules& rules)
      : polynomial_(integrand.polynomial), rules_(rules) {
    for (Ball& c : polynomial_) c = c.at(rules.bits());
  }

  Ball by_panels(const Piece& piece) const {
    Ball sum(0, rules_.bits());
    for (const GradedPanel& part : graded(piece.length, piece.left, piece.right, piece.outside)) {
      const BallPolynomial f = about(piece.start + part.from_left + part.length / 2);
      const bool is_polynomial = part.outside.empty();
      const int count = is_polynomial ? degree() / 2 + 1 : count_for(part.length, part.outside);
      if (count == 0) return Ball::unknown(rules_.bits());
      const PowerPanel panel(part.length, part.left, part.right, part.outside, count, rules_);
      const Ball half = part.length.at(64) / 2;
      sum += panel.sum([&](const PowerPanel::Node& node) { return value_at(f, offset(node)); },
                       is_polynomial ? panel.remainder_of_polynomial(bound_within(f, half))
                                     : panel.remainder(bound_within(f, half + panel.reach().at(64))));
    }
    return sum;
  }

  /// Returns the principal value for a piece without powers at its ends and with the pole in the middle.
  Ball symmetric_principal_value(const Piece& piece) const {
    const BallPolynomial f = about(piece.start + piece.length / 2);
    int count = count_for(piece.length, piece.outside);
    if (count == 0) return Ball::unknown(rules_.bits());
    count += count % 2;
    const PowerPanel panel(piece.length, Ball(0), Ball(0), piece.outside, count, rules_);
    const Ball bound = bound_within(f, piece.length.at(64) / 2 + panel.reach().at(64));
    return panel.sum([&](const PowerPanel::Node& node) { return value_at(f, offset(node)) / offset(node); },
                     panel.remainder_of_principal_value(bound));
  }

  Ball by_trapezoidal_rule(const Piece& piece, const std::optional<Trapezoidal::Pole>& pole) const {
    const BallPolynomial f = about(piece.start + piece.length / 2);
    const Trapezoidal rule(piece.length, piece.left, piece.right, piece.outside, pole, degree(), rules_.bits());
    return rule.integral([&](const Trapezoidal::Node& node) { return value_at(f, offset(node)); },
                         bound_within(f, rule.lens_radius()));
  }

 private:
  /// Returns the polynomial in x - centre.
  BallPolynomial about(const Ball& centre) const { return shifted(polynomial_, centre); }
  int degree() const { return static_cast<int>(polynomial_.size()) - 1; }
  /// Returns the offset from the middle of a panel.
  static Ball offset(const auto& node) { return (node.from_left - node.from_right) / 2; }
  /// Returns the number of nodes, including those for the polynomial's growth in the ellipse.
  int count_for(const Ball& length, const std::vector<OutsidePoint>& outside) const {
    const int count = PowerPanel::count_for(rules_.bits(), length, outside);
    return count == 0 ? 0 : count + degree() / 2;
  }

  BallPolynomial polynomial_;
  JacobiRules& rules_;
};

/// Returns the principal value over a piece with the pole at these distances from its ends, as the sum of the parts
/// left of, around and right of the pole.
Ball principal_value_by_panels(const PieceIntegral& integral, const Piece& piece, const Ball& from_left,
                               const Ball& from_right) {
  const Bits bits = piece.length.bits();
  // An exact number, a third of the distance to the nearer end.
  const Ball h = (min(from_left, from_right) / 3).at(32).lower().at(bits);
  if (!h.is_positive()) return Ball::unknown(bits);
  const Ball before = from_left - h, behind = from_right - h;
  Piece left{piece.start, before, piece.left, Ball(0), {}};
  Piece middle{piece.start + before, 2 * h, Ball(0), Ball(0), {}};
  Piece right{piece.start + from_left + h, behind, Ball(0), piece.right, {}};
  for (const OutsidePoint& point : piece.outside) {
    const bool on_left = point.side == Side::left;
    left.outside.push_back({point.side, on_left ? point.distance : point.distance + from_right + h, point.power});
    middle.outside.push_back({point.side, point.distance + (on_left ? before : behind), point.power});
    right.outside.push_back({point.side, on_left ? point.distance + from_left + h : point.distance, point.power});
  }
  left.outside.push_back({Side::right, from_right + h, piece.right});
  left.outside.push_back({Side::right, h, Ball(-1)});
  middle.outside.push_back({Side::left, before, piece.left});
  middle.outside.push_back({Side::right, behind, piece.right});
  right.outside.push_back({Side::left, from_left + h, piece.left});
  right.outside.push_back({Side::left, h, Ball(-1)});
  return integral.by_panels(right) - integral.by_panels(left) + integral.symmetric_principal_value(middle);
}

/// Returns why there is no integral; empty if there is one.
std::string refusal_of(const PowerIntegrand& integrand, std::size_t first, std::size_t last) {
  const std::vector<Ball>& e = integrand.points;
  if (!all_finite(e) || !all_finite(integrand.powers) || !all_finite(integrand.polynomial) ||
      (integrand.pole && !integrand.pole->is_finite())) {
    return "a number is not finite";
  }
  for (std::size_t j = 0; j + 1 < e.size(); ++j) {
    if (!(e[j] < e[j + 1]))
      return "points " + std::to_string(j) + " and " + std::to_string(j + 1) + " are not in order";
  }
  for (std::size_t j = first; j <= last; ++j) {
    if (!(integrand.powers[j] > -1)) return "the power at point " + std::to_string(j) + " is not certainly above -1";
    if (integrand.pole && !(*integrand.pole < e[j] || *integrand.pole > e[j])) {
      return "the pole is not certainly away from point " + std::to_string(j);
    }
  }
  return "";
}

}  // namespace

EnclosedIntegral enclosed_integral(const PowerIntegrand& integrand, std::size_t first, std::size_t last, Route route,
                                   JacobiRules& rules) {
  const std::vector<Ball>& e = integrand.points;
  if (!(first < last && last < e.size() && e.size() == integrand.powers.size())) {
    throw std::invalid_argument("enclosed integral: first < last, both among the points, each with a power");
  }
  const Bits bits = rules.bits();
  const std::string refusal = refusal_of(integrand, first, last);
  if (!refusal.empty()) return {Ball::unknown(bits), refusal};
  const PieceIntegral integral(integrand, rules);
  Ball sum(0, bits);
  if (integrand.polynomial.empty()) return {sum, ""};
  for (std::size_t k = first; k < last; ++k) {
    Piece piece = piece_between(integrand, k);
    int sign = 1;
    std::optional<Trapezoidal::Pole> inside;
    if (integrand.pole) {
      const Ball& t = *integrand.pole;
      if (t < e[k]) {
        piece.outside.push_back({Side::left, e[k] - t, Ball(-1)});
      } else if (t > e[k + 1]) {
        piece.outside.push_back({Side::right, t - e[k + 1], Ball(-1)});
        sign = -1;
      } else {
        inside = Trapezoidal::Pole{t - e[k], e[k + 1] - t};
      }
    }
    if (route == Route::trapezoidal) {
      sum += sign * integral.by_trapezoidal_rule(piece, inside);
    } else {
      sum += sign * (inside ? principal_value_by_panels(integral, piece, inside->from_left, inside->from_right)
                            : integral.by_panels(piece));
    }
  }
  if (!sum.is_finite()) return {Ball::unknown(bits), "a place next to the stretch is too near for its ball"};
  return {sum, ""};
}

}  // namespace steadyslide::enclosure
