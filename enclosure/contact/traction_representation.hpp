#pragma once
// The solution of A t = g + tilt on a contact set, enclosed for all values of its unknowns in a box: free ends, the
// polynomial q and the tilt. With g_k the polynomial of the slope on one piece (docs/theory.md),
//
//   u'/c = g_k + tilt - Y B_k off the contact,   t = eps cos(pi alpha) |Y| B_k on it,
//   B_k(x) = [(g_k + tilt)/Y]_poly - q(x)/pi - (1/pi) int_K eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x)
//
// [Bal16, theorem 36, reconstructed]. The integral runs over other pieces than the one in which B_k is asked for, but may
// come up to it. Beside such a point c, x at the distance d from it, with y the distance on the other side, a = -p and
// h(y) = y^a G(y) the integrand, G analytic across c,
//
//   int_0^L y^a G(y)/(y + d) dy = int_0^L y^a (G(y) - G(-d))/(y + d) dy + G(-d) int_0^L y^a/(y + d) dy
//
// (the last one in power_at_point.hpp), so that B_k = R + C d^m E(d): R and C are analytic up to c, m is the order of the zero
// of g - g_k at c. A quotient of differences on the ellipse is at most (max |G| + |G(-d)|)/(distance of -d from the ellipse).

#include <array>
#include <memory>

#include "enclosure/contact/panel_moments.hpp"
#include "enclosure/contact/segment_moments.hpp"
#include "enclosure/number/ball_polynomial.hpp"

namespace steadyslide::enclosure {

/// B_k at a place, B = regular + coefficient * singular, where singular may be unbounded at the point nearby.
struct LocalValue {
  Ball regular;      ///< R
  Ball coefficient;  ///< C
  Ball singular;     ///< d^m E(d), for d from the smallest (0 may not be finite)
  Ball least;        ///< a lower bound of it; a ball from a little to very much would lose it
  bool has_singular = false;
  Ball shift = Ball(0);  ///< of C d^m E(d) what is no power, or logarithm, of d alone

  /// -1 or 1 where it is decided, else 0.
  int sign() const;
  /// regular + coefficient * singular.
  Ball value() const;
  /// B less C' d^(a+m), or C' d^m log d.
  Ball analytic() const { return has_singular ? regular + shift : regular; }
};

class TractionRepresentation {
 public:
  /// `q`: coefficients of 1, xi, ... without the leading one, which is the load. `count` nodes a panel.
  TractionRepresentation(ContactSet set, BallPolynomial q, Ball tilt, int count, JacobiRules& rules);

  const ContactSet& set() const { return set_; }
  /// Nodes a panel.
  int count() const { return count_; }
  /// The work of B_k at one place, for a budget (work_budget.hpp).
  std::int64_t work_of_place() const { return work_of_place_; }
  /// The work of the panels of all segments, which the constructor makes.
  std::int64_t work_of_panels() const { return work_of_panels_; }
  /// With the load.
  const BallPolynomial& q() const { return q_; }
  /// B_k in a segment, k its own slope.
  LocalValue regular_factor(const Place& place) const { return regular_factor(slope_of(place.segment), place); }
  /// B_k of the contact at its end j, where nothing is singular.
  Ball regular_factor_at_end(std::size_t j) const;
  /// |Y| at a place, without the power of point `without`.
  Ball modulus(const Place& place, std::optional<std::size_t> without = std::nullopt) const;
  /// g_k + tilt at a place of a segment, k its own slope.
  Ball profile_slope(const Place& place) const;
  /// int (psi' - u')/c dxi over a part of a segment off the contact, from B_k. Where the part touches a segment in contact
  /// k is the slope there.
  Ball gap_change(const ContactPanel::Part& part, std::size_t k) const;

  // What conditions and loads are made of.
  /// The different polynomials g_k, and which of them holds on a segment.
  struct Slope {
    Polynomial exact;
    BallPolynomial coefficients;  ///< of g_k + tilt
    BallPolynomial rational;      ///< of [(g_k + tilt)/Y]_poly - q/pi
  };
  std::size_t slope_of(std::size_t segment) const { return set_.interval(segment).slope; }
  const Slope& slope(std::size_t k) const { return slopes_[k]; }
  /// g - g_k on a segment; in contact eps cos(pi alpha) times that.
  struct Difference {
    Polynomial exact;
    BallPolynomial coefficients;
    std::vector<std::vector<Ball>> values;  ///< at the nodes of each panel, times 1/|Y| and the node's weight
    std::vector<Ball> masses;               ///< (1/pi) int |...|/|Y| over each panel is no larger
    std::vector<Ball> sizes;                ///< max |...| in the far ellipse of each panel
    /// Seen from the left and from the right; made when they have been asked for often enough.
    mutable std::array<std::shared_ptr<const PanelMoments>, 2> moments;
    mutable std::array<Bits, 2> asked{};
    /// Present if there are many segments.
    std::optional<SegmentMoments> from_afar = {};
  };
  const Difference& difference(std::size_t k, std::size_t segment) const { return differences_[k][segment]; }
  /// Of 1/|Y|, on segments in contact, left to right; none where the contact has one polynomial.
  const std::vector<ContactPanel>& panels(std::size_t segment) const { return panels_[segment]; }
  /// Of |Y|, one power lower at the point `lowered`.
  ContactPanel panel(ContactPanel::Part part, std::optional<std::size_t> lowered = std::nullopt) const {
    return {set_, std::move(part), 1, lowered, count_, *rules_};
  }
  LocalValue regular_factor(std::size_t k, const Place& place) const;
  /// Before B_k is asked for at many places of a segment: all moments that pay then are made, and threads may ask.
  void prepare(std::size_t k, std::size_t segment) const;
  /// max |B_k| on the ellipse of a panel; without what a segment contributes.
  Ball bound(std::size_t k, const ContactPanel& panel, Ellipse ellipse,
             std::optional<std::size_t> without = std::nullopt) const;
  /// Y = z^S (y_0 + y_1/z + ...): y_n. 0 for n < 0.
  Ball expansion(int n) const { return coefficient(expansion_, n); }
  /// 1/Y = z^-S (d_0 + d_1/z + ...): d_n.
  Ball reciprocal(int n) const { return coefficient(reciprocal_, n); }

 private:
  Ball coefficient(const std::vector<Ball>& series, int n) const {
    return n < 0 ? Ball(0, set_.bits()) : series[static_cast<std::size_t>(n)];
  }
  // What the constructor does: series at infinity, then for each slope and each segment what B_k is made of.
  void expand_at_infinity();
  void take_polynomial_parts(Slope& slope);
  void take_differences(std::size_t segment);
  /// Adds a segment's part of int eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x).
  void add_cauchy(std::size_t k, std::size_t segment, const Place& place, LocalValue& sum) const;
  /// The moments of the panels of `segment` for places in `seen_from`. None at first: they cost as much as all panels do for
  /// half as many places as they have bits.
  const PanelMoments* moments(const Difference& difference, std::size_t segment, std::size_t seen_from) const;
  void add_beside(const ContactPanel& panel, const Difference& difference, const std::vector<Ball>& values,
                  const Place& place, LocalValue& sum) const;
  Ball distance(const Place& place, std::size_t j) const;
  Ball coordinate(const Place& place) const;

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
