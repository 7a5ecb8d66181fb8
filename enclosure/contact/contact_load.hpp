#pragma once
// The load on a segment in contact, int t dxi, enclosed: apart from the conditions, which know the whole load only.
//
// Beside a point where the contact changes its polynomial, t = eps cos(pi alpha) |Y| R + (g - g_k) times a constant, or times
// log d: the first is integrated by a Jacobi rule, the second is a polynomial.

#include "enclosure/contact/contact_form.hpp"

namespace steadyslide::enclosure {

class ContactLoad {
 public:
  /// `form` has to outlive it.
  explicit ContactLoad(const ContactForm& form) : form_(form), set_(form.set()) {}

  Ball load_on(std::size_t segment) const;

 private:
  bool changes_polynomial(std::size_t j) const;
  /// The panel on the other side of c that touches it.
  const ContactPanel& facing_panel(std::size_t c, std::size_t segment) const;
  /// In a segment beside such a point c: a bound of B_k without its singular term on the ellipse of a panel that touches c.
  Ball bound_beside(std::size_t c, const ContactPanel& panel) const;
  /// The integral of t's singular term beside c, from c to the distance `length`.
  Ball singular_load(std::size_t c, std::size_t segment, const Ball& length) const;

  const ContactForm& form_;
  const ContactSet& set_;
};

}  // namespace steadyslide::enclosure
