#pragma once
// Enclosed integrals of the traction over a part of a segment in contact, int t w dxi for analytic w. They are
// independent of the conditions, which contain only the total load.
//
// Beside a point c where the contact changes its polynomial, at the distance d from it,
//
//   t = eps cos(pi alpha) |Y| R + (g - g_k) S, S a constant, or a constant times log d if c has no power;
//
// a Jacobi rule integrates the first term; the second term is a polynomial times S.

#include <functional>

#include "enclosure/contact/traction_representation.hpp"

namespace steadyslide::enclosure {

/// A rule for int t w dxi on a panel: sum values_i w(node_i), and separately the singular term, if there is one.
struct TractionRule {
  ContactPanel panel;
  std::vector<Ball> values;  ///< empty if the panel's load is neglected
  Ball bound;                ///< bound of |t|/|Y| in the far ellipse
  Ball neglected;            ///< upper bound of int |t| over the panel, if it is neglected

  /// Returns an error bound of the sum, for |w| <= largest in the far ellipse.
  Ball error(const Ball& largest) const {
    return values.empty() ? neglected * largest : panel.remainder(bound * largest, Ellipse::far);
  }

  /// (g - g_k) S on the panel, which touches c: x = c +- d.
  struct Singular {
    BallPolynomial factor;  ///< in +-d, with S or the factor of the logarithm
    bool logarithm;
    int direction;  ///< 1 if x = c + d
  };
  std::optional<Singular> singular;
};

class ContactLoad {
 public:
  /// `form` must outlive this object. `threads` threads share the work on many places. The results do not depend on
  /// their number.
  explicit ContactLoad(const TractionRepresentation& form, unsigned threads = 1)
      : form_(form), set_(form.set()), threads_(threads) {}

  Ball load_on(std::size_t segment) const;
  /// Returns the integral between two distances from the segment's left point; the second may be the segment's length.
  /// `weight` is a polynomial in xi.
  Ball load_on(std::size_t segment, const ContactPanel::DistanceRange& range, const BallPolynomial& weight) const;

  /// Returns rules for such a range. `longest` returns the largest length of a panel for a part of the segment.
  using Longest = std::function<Ball(const ContactPanel::Interval&)>;
  std::vector<TractionRule> rules(std::size_t segment, const ContactPanel::DistanceRange& range,
                                  const Longest& longest) const;

 private:
  bool changes_polynomial(std::size_t j) const;
  /// Returns the panel on the other side of c that touches c.
  const ContactPanel& facing_panel(std::size_t c, std::size_t segment) const;
  /// For a segment beside such a point c, returns a bound of B_k without its singular term on the ellipse of a panel
  /// that touches c.
  Ball bound_beside(std::size_t c, const ContactPanel& panel) const;
  TractionRule::Singular singular_term(std::size_t c, std::size_t segment) const;
  TractionRule rule(ContactPanel::Interval part) const;

  const TractionRepresentation& form_;
  const ContactSet& set_;
  unsigned threads_;
};

}  // namespace steadyslide::enclosure
