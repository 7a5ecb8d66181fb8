#pragma once
// The conditions on the unknowns of a contact set: its free ends e_f, the polynomial q, the tilt. With
//
//   u'/(c Y) = m_0/z + m_1/z^2 + ... + q/pi,
//
//   moments         m_j = 0 for j < S, and P/pi as the coefficient of 1/z in u'/c;
//   gaps            int psi' - u' over each gap, the profile's steps added, is 0;
//   moment of load  the coefficient of z^-2 in u'/c is P load_at/pi, where the indenter may tilt.
//
// The gap at one place, enclosed, in units of c xi, is
//
//   gap/c = steps of the profile + int (psi' - u')/c dxi   from the nearer end of contact to the place,
//
// int (psi' - u')/c = int (g - g_k) + Y B_k, where k is the slope of the contact at that end. With this k, B_k is
// analytic up to the end.
//
// The derivatives of the conditions need no derivative of an integral: near e_f, d(u'/c)/d e_f = Y
// (rho_f/(z - e_f) + r(z)) with rho_f = p_f B(e_f) and r the polynomial part of -p_f q/(pi (z - e_f)); d/d tilt is
// 1 - Y [1/Y]_poly. (Liouville's theorem.)

#include <algorithm>

#include "enclosure/contact/traction_representation.hpp"

namespace steadyslide::enclosure {

class ContactConditions {
 public:
  /// `form` must outlive this object.
  explicit ContactConditions(const TractionRepresentation& form)
      : form_(form),
        set_(form.set()),
        q_(form.q()),
        degree_(set_.degree_at_infinity()),
        movable_(set_.topology().movable()),
        free_coefficients_(static_cast<std::size_t>(std::max(-degree_ - 1, 0))) {}

  /// Returns the work of the form and of conditions(), for a budget (work_budget.hpp).
  std::int64_t work() const;
  /// Returns the conditions in the order moments, gaps, moment of the load. All are 0 for a solution.
  std::vector<Ball> conditions() const;
  /// Returns their derivatives with respect to the logarithms of the offsets, the coefficients of q and the tilt, and
  /// in the last column the load. (The conditions are linear in the load and in q.)
  std::vector<std::vector<Ball>> jacobian() const;
  /// Returns the number of unknowns. If the number of conditions differs, there is no isolated solution.
  std::size_t unknowns() const;
  /// Returns int xi t dxi / int t dxi, from the expansion at infinity.
  Ball centre_of_pressure() const;
  /// Returns the gap at a place in a segment outside the contact. The place must be thin. Not finite if there is no
  /// contact on either side.
  Ball gap_at(const SurfacePoint& place) const;

 private:
  /// Returns int eps cos(pi alpha) (g - g_k)/|Y| x^j dx over the contact.
  Ball integral(std::size_t k, std::size_t j) const;
  /// Returns m_j.
  Ball moment(std::size_t j) const;
  /// Returns the coefficient of z^-2 in u'/c, which is (1/pi) times the load's moment.
  Ball second_coefficient() const;
  Ball gap_condition(const ContactSet::Run& gap) const;
  std::vector<Ball> gap_derivatives(const ContactSet::Run& gap, const std::vector<Ball>& residues) const;

  const TractionRepresentation& form_;
  const ContactSet& set_;
  const BallPolynomial& q_;
  int degree_;
  std::vector<std::size_t> movable_;
  std::size_t free_coefficients_;  ///< number of coefficients of q without the load
};

}  // namespace steadyslide::enclosure
