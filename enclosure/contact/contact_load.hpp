#pragma once
// Integrals of the traction over a part of a segment in contact, int t w dxi for w analytic, enclosed: apart from the
// conditions, which know the whole load only.
//
// Beside a point c where the contact changes its polynomial, at the distance d from it,
//
//   t = eps cos(pi alpha) |Y| R + (g - g_k) S,   S a constant, or a constant times log d where c carries no power;
//
// the first is integrated by a Jacobi rule, the second is a polynomial times S.

#include <functional>

#include "enclosure/contact/traction_representation.hpp"

namespace steadyslide::enclosure {

/// A rule for int t w dxi on a panel: sum values_i w(node_i); and the singular term apart, if there is one.
struct TractionRule {
  ContactPanel panel;
  std::vector<Ball> values;  ///< none where the panel's load is neglected
  Ball bound;                ///< of |t|/|Y| in the far ellipse
  Ball neglected;            ///< int |t| over the panel is no larger, where it is

  /// What the sum is off by at most, |w| <= largest in the far ellipse.
  Ball error(const Ball& largest) const {
    return values.empty() ? neglected * largest : panel.remainder(bound * largest, Ellipse::far);
  }

  /// (g - g_k) S on the panel, which touches c: x = c +- d.
  struct Singular {
    BallPolynomial factor;  ///< of +-d, with S or what multiplies the logarithm
    bool logarithm;
    int direction;  ///< 1 where x = c + d
  };
  std::optional<Singular> singular;
};

class ContactLoad {
 public:
  /// `form` has to outlive it. `threads` share the work on many places; what they find does not depend on how many they are.
  explicit ContactLoad(const TractionRepresentation& form, unsigned threads = 1)
      : form_(form), set_(form.set()), threads_(threads) {}

  Ball load_on(std::size_t segment) const;
  /// Between two distances from the segment's left point, the second of which may be the segment's length; `weight` is a
  /// polynomial in xi.
  Ball load_on(std::size_t segment, const ContactPanel::Range& range, const BallPolynomial& weight) const;

  /// Rules for such a range. `longest` says of a part of the segment how long a panel may be there.
  using Longest = std::function<Ball(const ContactPanel::Part&)>;
  std::vector<TractionRule> rules(std::size_t segment, const ContactPanel::Range& range, const Longest& longest) const;

 private:
  bool changes_polynomial(std::size_t j) const;
  /// The panel on the other side of c that touches it.
  const ContactPanel& facing_panel(std::size_t c, std::size_t segment) const;
  /// In a segment beside such a point c: a bound of B_k without its singular term on the ellipse of a panel that touches c.
  Ball bound_beside(std::size_t c, const ContactPanel& panel) const;
  TractionRule::Singular singular_term(std::size_t c, std::size_t segment) const;
  TractionRule rule(ContactPanel::Part part) const;

  const TractionRepresentation& form_;
  const ContactSet& set_;
  unsigned threads_;
};

}  // namespace steadyslide::enclosure
