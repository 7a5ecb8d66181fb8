#pragma once
// Proves that a contact set's conditions have exactly one zero in a box. With the conditions F, the midpoint v of the
// box V, and an approximate inverse C of F'(v): if Krawczyk's operator
//
//   K(V) = v - C F(v) + (1 - C F'(V)) (V - v)
//
// maps V into its interior, then F has exactly one zero in V, and it lies in K(V). (F' is enclosed on all of V, on
// which the points keep their order; Brouwer's theorem for existence, |1 - C F'(V)| < 1 for uniqueness.)
//
// If the problem has all loads from p - r to p + r, then F(v; load) = F(v; p) + dF/dload (load - p), because F is
// linear in the load, and -C dF/dload [-r, r] is added to K(V). Then there is exactly one zero in V for each of these
// loads.

#include <optional>
#include <string>
#include <vector>

#include "enclosure/contact/contact_conditions.hpp"
#include "enclosure/number/work_budget.hpp"
#include "model/approximate_contact.hpp"

namespace steadyslide::enclosure {

/// The unknowns of a contact set: logarithms of the movable ends' offsets, q without its leading coefficient, the tilt.
struct ContactBox {
  ContactTopology topology;
  std::vector<Ball> log_offsets;
  std::vector<Ball> q;
  Ball tilt;  ///< exactly 0 if the indenter cannot tilt

  /// Returns all unknowns in one list. A tilt that is not unknown may be left out.
  std::vector<Ball> unknowns(bool with_tilt = true) const;
  ContactBox with(const std::vector<Ball>& unknowns) const;
  /// Returns the form at the rules' precision, with `count` nodes for each panel.
  TractionRepresentation form(const ReducedProblem& problem, int count, JacobiRules& rules) const;
};

/// The points of a contact that a solver found, together with the problem's other anchors. The offsets are empty if the
/// contact names an anchor that the problem does not have.
struct ContactStart {
  ContactTopology topology;
  std::vector<Rational> offsets;  ///< offsets of the movable ends, in xi, > 0

  ContactStart(const ReducedProblem& problem, const ApproximateContact& contact);
  ContactBox box(Bits bits) const;
};

struct KrawczykResult {
  bool proved = false;
  std::string reason;  ///< the reason if it is not proved
  ContactBox box;      ///< K(V) if proved; otherwise the best state reached
  /// If proved: K(V) for the smallest load only and for the largest load only. Their width is of second order in V's
  /// width.
  ContactBox at_smallest = {};
  ContactBox at_largest = {};
};

// All these functions stop when the work budget is spent.

/// Proves that the given box contains exactly one zero. It makes no Newton step before.
KrawczykResult prove_zero(const ReducedProblem& problem, const ContactBox& box, JacobiRules& rules, WorkBudget& work);
/// For one load: Newton's method from the middle of a box, then a proof for a box around its result. The conditions are
/// affine in q and the tilt, so the first step finds these from any start.
KrawczykResult enclose_zero(const ReducedProblem& problem, const ContactBox& box, JacobiRules& rules, WorkBudget& work);

/// Returns a box of the zeros for all of a problem's loads, to first order, with a margin: Newton's method from the
/// middle of `guess` to the zero of the middle load, and |dv/dload| there. This is not a proof. Absent if it does not
/// converge.
std::optional<ContactBox> box_for_loads(const ReducedProblem& problem, const ContactBox& guess, JacobiRules& rules,
                                        WorkBudget& work);

/// Returns the number of nodes for each panel at which the quadrature error is that of rounding.
int count_for(Bits bits);

}  // namespace steadyslide::enclosure
