#pragma once
// The sign of the traction in the limit at a point of the contact, from the leading term of its local form. It is
// decided without samples: t > 0 may hold on 1e-100 of the contact or less, where no place is ever sampled.
// D = psi'(c+) - psi'(c-), [s] = s(c+) - s(c-), d the distance from the point:
//
//   end: edge, step, free end     t ~ -theta d^p                                       theta > 0
//   jump, no wedge                t ~ -theta cos(pi alpha) d^beta                      theta > 0
//   wedge and jump, beta < 0      t ~ D/[s] - theta cos(pi alpha) d^beta               theta > 0, for any D
//   wedge and jump, beta > 0      the same, but the constant leads                     D/[s] < 0
//   wedge, no jump                t ~ D/(1+s^2) log(d)/pi                              D > 0
//   curvature alone, no jump      t(c)                                                 t(c) < 0
//
// beta < 0 where [s] > 0. [Bal16, theorems 2 and 3]

#include <optional>
#include <string>
#include <vector>

#include "numeric/riemann_hilbert/traction_representation.hpp"

namespace steadyslide::numeric {

template <Real R>
struct LeadingTerm {
  enum class Kind { power, constant, logarithm } kind;
  Estimate<R> coefficient;  ///< theta, D/[s] or D/(1+s^2) of the table, reduced and in xi
  R power;                  ///< of d; 0 except for Kind::power
  int sign;                 ///< sign of t next to the point; 0 if the error leaves it undecided
};

/// Returns the leading term; absent at a point that is neither an end of contact nor an anchor inside it. `end_error`
/// is the absolute error of the free ends in xi.
template <Real R>
std::optional<LeadingTerm<R>> leading_term(const TractionRepresentation<R>& form, std::size_t point,
                                           const R& end_error = R(0));

/// Returns the range of tension if the leading term is tension inside the contact: the logarithm of the distance in xi
/// at which the local form (constant and power or logarithm) changes its sign. Absent if it does not.
template <Real R>
std::optional<R> log_reach(const TractionRepresentation<R>& form, std::size_t point);

/// A hairline gap over an anchor inside the contact. The tension at the anchor reaches at most 1e30 shortest gaps; the
/// length of the gap is this distance times a factor. So only the logarithm of its length is known. Apart from this
/// gap, the set with contact there is that of the solution. At a distance d, the effect of the gap is of the order of
/// length/d, which is negligible at every place that a number can represent.
template <Real R>
struct HairlineGap {
  std::size_t anchor;
  R log_length;  ///< logarithm of its length in xi, by order of magnitude
};

/// Returns the hairline gaps from left to right.
template <Real R>
std::vector<HairlineGap<R>> hairline_gaps(const TractionRepresentation<R>& form, const R& end_error);

/// True if the leading term is tension and reaches farther than over a hairline gap.
template <Real R>
bool pulls(const TractionRepresentation<R>& form, std::size_t point, const std::optional<LeadingTerm<R>>& term);

/// Returns the supremum of t at the points where the leading term is known to be tension: infinite if it blows up; 0 if
/// there is no such point. Hairline gaps do not count.
template <Real R>
R highest_limit(const TractionRepresentation<R>& form, const R& end_error);

/// Returns text such as "the leading term at x = 0 pulls: theta = -0.41 +- 3e-15", with lengths in the user's unit.
template <Real R>
std::string in_words(const TractionRepresentation<R>& form, std::size_t point, const LeadingTerm<R>& term);

}  // namespace steadyslide::numeric
