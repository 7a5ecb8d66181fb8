#pragma once
// Exactly one zero of a contact set's conditions in a box. With F the conditions, v the midpoint of the box V, C an
// approximate inverse of F'(v), Krawczyk's operator
//
//   K(V) = v - C F(v) + (1 - C F'(V)) (V - v)
//
// maps V into its interior: then F has one zero in V, and it lies in K(V). (F' is enclosed on all of V, on which the
// points keep their order; Brouwer's theorem for existence, |1 - C F'(V)| < 1 for uniqueness.)
//
// Where the problem's load is any from p - r to p + r, F(v; load) = F(v; p) + dF/dload (load - p), since the load enters
// linearly, and -C dF/dload [-r, r] belongs to K(V): then there is exactly one zero in V for each of these loads.

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
  Ball tilt;  ///< 0 exactly where the indenter keeps its attitude

  /// All of them in one list. A tilt that is not unknown may be left out.
  std::vector<Ball> unknowns(bool with_tilt = true) const;
  ContactBox with(const std::vector<Ball>& unknowns) const;
  /// At the rules' precision, with `count` nodes a panel.
  TractionRepresentation form(const ReducedProblem& problem, int count, JacobiRules& rules) const;
};

/// The points of a contact as a solver found it, the problem's other anchors among them; empty offsets where the contact
/// names an anchor that the problem does not have.
struct ContactStart {
  ContactTopology topology;
  std::vector<Rational> offsets;  ///< of the movable ends, in xi, > 0

  ContactStart(const ReducedProblem& problem, const ApproximateContact& contact);
  ContactBox box(Bits bits) const;
};

struct KrawczykResult {
  bool proved = false;
  std::string reason;  ///< why not
  ContactBox box;      ///< K(V), if proved; else the best state reached
  /// The zeros for the smallest and the largest load alone, if proved: K(V) of these, of second order in V's width.
  ContactBox at_smallest = {};
  ContactBox at_largest = {};
};

// All of them end when the budget of work is spent.

/// Does the box hold exactly one zero? No Newton step before it: the box is taken as it is.
KrawczykResult prove_zero(const ReducedProblem& problem, const ContactBox& box, JacobiRules& rules, WorkBudget& work);
/// Newton's method from the middle of a box, then a box around where it leads, for one load. The conditions are affine in q
/// and the tilt, which its first step finds from nothing.
KrawczykResult enclose_zero(const ReducedProblem& problem, const ContactBox& box, JacobiRules& rules, WorkBudget& work);

/// The box of the zeros for all of a problem's loads, to first order, with a margin: Newton's method from the middle of
/// `guess` to the middle load's zero, and |dv/dload| from there. Proves nothing; nothing where it does not converge.
std::optional<ContactBox> box_for_loads(const ReducedProblem& problem, const ContactBox& guess, JacobiRules& rules,
                                        WorkBudget& work);

/// Nodes a panel that leave the quadrature's error at the precision's rounding.
int count_for(Bits bits);

}  // namespace steadyslide::enclosure
