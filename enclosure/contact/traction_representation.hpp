#pragma once
// The solution of A t = g + tilt on a contact set, enclosed for all values of its unknowns in a box: free ends, the
// polynomial q and the tilt. With the polynomial g_k of the slope on one piece (docs/theory.md),
//
//   u'/c = g_k + tilt - Y B_k outside the contact,   t = eps cos(pi alpha) |Y| B_k on it,
//   B_k(x) = [(g_k + tilt)/Y]_poly - q(x)/pi - (1/pi) int_K eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x)
//
// [Bal16, theorem 36, reconstructed]. The integral is over other pieces than the one of the place x, but it may end at
// this piece. Let c be such a point, d the distance of x from c, y the distance on the other side, a = -p and
// h(y) = y^a G(y) the integrand, with G analytic across c. Then
//
//   int_0^L y^a G(y)/(y + d) dy = int_0^L y^a (G(y) - G(-d))/(y + d) dy + G(-d) int_0^L y^a/(y + d) dy
//
// (the last integral is in power_at_point.hpp), so B_k = R + C d^m E(d), where R and C are analytic up to c, and m is
// the order of the zero of g - g_k at c. The difference quotient on the ellipse is at most (max
// |G| + |G(-d)|)/(distance of -d from the ellipse).

#include <array>
#include <memory>

#include "enclosure/contact/panel_moments.hpp"
#include "enclosure/contact/segment_moments.hpp"
#include "enclosure/number/ball_polynomial.hpp"

namespace steadyslide::enclosure {

/// B_k at a place, B = regular + coefficient * singular. `singular` may be unbounded at the nearby point.
struct LocalValue {
  Ball regular;      ///< R
  Ball coefficient;  ///< C
  Ball singular;     ///< d^m E(d); at d = 0 it may not be finite
  Ball least;        ///< a lower bound of `singular`, which a very wide ball would lose
  bool has_singular = false;
  Ball shift = Ball(0);  ///< the part of C d^m E(d) that is not a pure power or logarithm of d

  /// Returns -1 or 1 if the sign is decided; otherwise 0.
  int sign() const;
  /// Returns regular + coefficient * singular.
  Ball value() const;
  /// Returns B minus C' d^(a+m), or minus C' d^m log d.
  Ball analytic() const { return has_singular ? regular + shift : regular; }
};

class TractionRepresentation {
 public:
  /// `q` are the coefficients of 1, xi, ... without the leading one, which is the load. `count` is the number of nodes
  /// for each panel.
  TractionRepresentation(ContactSet set, BallPolynomial q, Ball tilt, int count, JacobiRules& rules);

  const ContactSet& set() const { return set_; }
  /// Returns the number of nodes for each panel.
  int count() const { return count_; }
  /// Returns the work of B_k at one place, for a budget (work_budget.hpp).
  std::int64_t work_of_place() const { return work_of_place_; }
  /// Returns the work for the panels of all segments, which the constructor makes.
  std::int64_t work_of_panels() const { return work_of_panels_; }
  /// Returns q with the load.
  const BallPolynomial& q() const { return q_; }
  /// Returns B_k in a segment, where k is its own slope.
  LocalValue regular_factor(const SurfacePoint& place) const { return regular_factor(slope_of(place.segment), place); }
  /// Returns B_k of the contact at its end j, where it is not singular.
  Ball regular_factor_at_end(std::size_t j) const;
  /// Returns |Y| at a place, without the power of point `without`.
  Ball modulus(const SurfacePoint& place, std::optional<std::size_t> without = std::nullopt) const;
  /// Returns g_k + tilt at a place of a segment, where k is its own slope.
  Ball profile_slope(const SurfacePoint& place) const;
  /// Returns int (psi' - u')/c dxi over a part of a segment outside the contact, from B_k. If the part touches a
  /// segment in contact, k must be the slope there.
  Ball gap_change(const ContactPanel::Interval& part, std::size_t k) const;

  // Functions for conditions and loads.
  /// The different polynomials g_k, and the index of the one on a segment.
  struct Slope {
    Polynomial exact;
    BallPolynomial coefficients;  ///< coefficients of g_k + tilt
    BallPolynomial rational;      ///< coefficients of [(g_k + tilt)/Y]_poly - q/pi
  };
  std::size_t slope_of(std::size_t segment) const { return set_.interval(segment).slope; }
  const Slope& slope(std::size_t k) const { return slopes_[k]; }
  /// g - g_k on a segment; in contact multiplied by eps cos(pi alpha).
  struct Difference {
    Polynomial exact;
    BallPolynomial coefficients;
    std::vector<std::vector<Ball>> values;  ///< at the nodes of each panel, times 1/|Y| and the node's weight
    std::vector<Ball> masses;               ///< upper bounds of (1/pi) int |...|/|Y| over each panel
    std::vector<Ball> sizes;                ///< max |...| in the far ellipse of each panel
    /// The moments for places on the left and on the right. They are made after a sufficient number of uses.
    mutable std::array<std::shared_ptr<const PanelMoments>, 2> moments;
    mutable std::array<Bits, 2> asked{};
    /// Present if there are many segments.
    std::optional<SegmentMoments> from_afar = {};
  };
  const Difference& difference(std::size_t k, std::size_t segment) const { return differences_[k][segment]; }
  /// Returns the panels of 1/|Y| on segments in contact, from left to right; empty if the contact has one polynomial.
  const std::vector<ContactPanel>& panels(std::size_t segment) const { return panels_[segment]; }
  /// Returns a panel of |Y|, with a power lower by one at the point `lowered`.
  ContactPanel panel(ContactPanel::Interval part, std::optional<std::size_t> lowered = std::nullopt) const {
    return {set_, std::move(part), 1, lowered, count_, *rules_};
  }
  LocalValue regular_factor(std::size_t k, const SurfacePoint& place) const;
  /// Call this before computing B_k at many places of a segment. It makes all moments that pay off; after it, threads
  /// may compute B_k.
  void prepare(std::size_t k, std::size_t segment) const;
  /// Returns max |B_k| on the ellipse of a panel, without the contribution of a segment.
  Ball bound(std::size_t k, const ContactPanel& panel, Ellipse ellipse,
             std::optional<std::size_t> without = std::nullopt) const;
  /// Returns y_n in Y = z^S (y_0 + y_1/z + ...); 0 for n < 0.
  Ball expansion(int n) const { return coefficient(expansion_, n); }
  /// Returns d_n in 1/Y = z^-S (d_0 + d_1/z + ...).
  Ball reciprocal(int n) const { return coefficient(reciprocal_, n); }

 private:
  Ball coefficient(const std::vector<Ball>& series, int n) const {
    return n < 0 ? Ball(0, set_.bits()) : series[static_cast<std::size_t>(n)];
  }
  // Steps of the constructor: series at infinity, then the data of B_k for each slope and each segment.
  void expand_at_infinity();
  void take_polynomial_parts(Slope& slope);
  void take_differences(std::size_t segment);
  /// Adds a segment's contribution to int eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x).
  void add_cauchy(std::size_t k, std::size_t segment, const SurfacePoint& place, LocalValue& sum) const;
  /// Returns the moments of the panels of `segment` for places in `seen_from`. Null at first, because moments cost as
  /// much as direct sums for a number of places that is half the number of bits.
  const PanelMoments* moments(const Difference& difference, std::size_t segment, std::size_t seen_from) const;
  void add_beside(const ContactPanel& panel, const Difference& difference, const std::vector<Ball>& values,
                  const SurfacePoint& place, LocalValue& sum) const;
  Ball distance(const SurfacePoint& place, std::size_t j) const;
  Ball coordinate(const SurfacePoint& place) const;

  ContactSet set_;
  BallPolynomial q_;
  Ball tilt_;
  int count_;
  std::int64_t work_of_place_ = 0;
  std::int64_t work_of_panels_ = 0;
  JacobiRules* rules_;
  std::vector<Ball> expansion_;
  std::vector<Ball> reciprocal_;
  std::vector<Slope> slopes_;
  std::vector<std::vector<ContactPanel>> panels_;
  std::vector<std::vector<Difference>> differences_;  ///< [k][segment]
};

}  // namespace steadyslide::enclosure
