#pragma once
// The solution of A t = g + tilt on a contact set, enclosed for all values of its unknowns in a box: free ends, the
// polynomial q and the tilt. With g_k the polynomial of the slope on one piece,
//
//   u'/c = g_k + tilt - Y B_k off the contact,   t = eps cos(pi alpha) |Y| B_k on it,
//   B_k(x) = [(g_k + tilt)/Y]_poly - q(x)/pi - (1/pi) int_K eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x)
//
// [Bal16, theorem 36, reconstructed]. The integral runs over other pieces than the one in which B_k is asked for, but may
// come up to it. Beside such a point c, x at the distance d from it, with y the distance on the other side, a = -p and
// h(y) = y^a G(y) the integrand, G analytic across c,
//
//   int_0^L y^a G(y)/(y + d) dy = int_0^L y^a (G(y) - G(-d))/(y + d) dy + G(-d) I(d),
//   I(d) = -pi d^a/sin(pi a) - L^a sum_{k>=0} (-d/L)^k/(k - a),   or log(L + d) - log d where a = 0,
//
// so that B_k = R + C d^(a+m), or R - C d^m log d: R and C are analytic up to c, m is the order of the zero of g - g_k
// at c. A quotient of differences on the ellipse is at most (max |G| + |G(-d)|)/(distance of -d from the ellipse).

#include "enclosure/contact/contact_panel.hpp"

namespace steadyslide::enclosure {

/// A point of the support: in segment k of the contact set, with its distances from both points. They may be wide.
struct Place {
  std::size_t segment;
  Ball from_left;
  Ball from_right;
};

/// B_k at a place, B = regular + coefficient * singular, where singular may be unbounded at the point nearby.
struct LocalValue {
  Ball regular;
  Ball coefficient;  ///< C
  Ball singular;     ///< d^(a+m), or -d^m log d, for d from the smallest (0 is not finite) ...
  Ball least;        ///< ... and, where it is unbounded, its lower bound: positive
  bool has_singular = false;

  /// -1 or 1 where it is decided, else 0.
  int sign() const;
  /// regular + coefficient * singular.
  Ball value() const;
};

class ContactForm {
 public:
  /// `q`: coefficients of 1, xi, ... without the leading one, which is the load. `count` nodes a panel.
  ContactForm(ContactSet set, std::vector<Ball> q, Ball tilt, int count, JacobiRules& rules);

  const ContactSet& set() const { return set_; }
  /// B_k in a segment, k its own slope.
  LocalValue regular_factor(const Place& place) const { return regular_factor(slopes_of_[place.segment], place); }
  /// B_k of the contact at its end j, where nothing is singular.
  Ball regular_factor_at_end(std::size_t j) const;
  /// |Y| at a place, without the power of point `without`.
  Ball modulus(const Place& place, std::optional<std::size_t> without = std::nullopt) const;
  /// int t dxi over a segment in contact.
  Ball load_on(std::size_t segment) const;
  /// g_k + tilt at a place of a segment, k its own slope.
  Ball profile_slope(const Place& place) const;
  /// int xi t dxi / int t dxi, from the expansion at infinity.
  Ball centre_of_pressure() const;
  /// The conditions on the unknowns, in the order moments, gaps, moment of the load: all of them are 0 at a solution.
  std::vector<Ball> conditions() const;
  /// Their derivatives by the logarithms of the offsets, the coefficients of q and the tilt.
  std::vector<std::vector<Ball>> jacobian() const;
  /// The number of unknowns; that of conditions is the same, or there is no isolated solution.
  std::size_t unknowns() const;

 private:
  using Polynomials = std::vector<Ball>;
  struct Slope {
    Polynomial exact;
    Polynomials coefficients;  ///< of g_k + tilt
    Polynomials rational;      ///< of [(g_k + tilt)/Y]_poly - q/pi
  };
  /// eps cos(pi alpha) (g - g_k) on a segment.
  struct Difference {
    Polynomial exact;
    Polynomials coefficients;
    std::vector<std::vector<Ball>> values;  ///< at the nodes of each panel, times 1/|Y| and the node's weight
    std::vector<Ball> masses;               ///< (1/pi) int |...|/|Y| over each panel is no larger
  };

  LocalValue regular_factor(std::size_t k, const Place& place) const;
  /// Of the panels of a segment: its part of int eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x).
  void add_cauchy(std::size_t k, std::size_t segment, const Place& place, LocalValue& sum) const;
  void add_beside(const ContactPanel& panel, const Difference& difference, const std::vector<Ball>& values,
                  const Place& place, LocalValue& sum) const;
  Ball distance(const Place& place, std::size_t j) const;
  Ball coordinate(const Place& place) const;
  /// int eps cos(pi alpha) (g - g_k)/|Y| x^j dx over the contact.
  Ball integral(std::size_t k, std::size_t j) const;
  Ball moment(std::size_t j) const;
  /// The coefficient of z^-2 of u'/c: (1/pi) times the load's moment.
  Ball second_coefficient() const;
  Ball gap_condition(const ContactSet::Run& gap) const;
  std::vector<Ball> gap_derivatives(const ContactSet::Run& gap, const std::vector<Ball>& residues) const;
  /// max |B_k| on the ellipse of a panel; without what a segment contributes.
  Ball bound(std::size_t k, const ContactPanel& panel, Ellipse ellipse,
             std::optional<std::size_t> without = std::nullopt) const;
  /// In a segment in contact, beside its point c on the other side of which the contact has another polynomial: a bound
  /// of B_k without its singular term on the ellipse of a panel that touches c.
  Ball bound_beside(std::size_t c, const ContactPanel& panel) const;
  /// The integral of t's singular term beside c, from c to the distance `length`: a polynomial, times log d where p = 0.
  Ball singular_load(std::size_t c, std::size_t segment, const Ball& length) const;
  /// The panel on the other side of c that touches it.
  const ContactPanel& facing_panel(std::size_t c, std::size_t segment) const;
  bool changes_polynomial(std::size_t j) const;
  Ball series(const std::vector<Ball>& coefficients, int n) const;

  ContactSet set_;
  Polynomials q_;  ///< with the load
  Ball tilt_;
  int count_;
  JacobiRules* rules_;
  int degree_;
  std::vector<Ball> y_series_;    ///< Y = z^S (y_0 + y_1/z + ...)
  std::vector<Ball> reciprocal_;  ///< 1/Y = z^-S (d_0 + d_1/z + ...)
  std::vector<Slope> slopes_;
  std::vector<std::size_t> slopes_of_;
  std::vector<std::vector<ContactPanel>> panels_;  ///< of 1/|Y|, for each segment in contact where there are two slopes
  std::vector<std::vector<Difference>> differences_;  ///< [k][segment]
};

}  // namespace steadyslide::enclosure
