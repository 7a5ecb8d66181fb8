#pragma once
// The sign of the traction in the limit at a point of the contact, from the leading term of its local form: decided,
// and not looked for. t > 0 may hold on a stretch of 1e-100 of the contact and less, where no place is ever looked at.
// D = psi'(c+) - psi'(c-), [s] = s(c+) - s(c-), d the distance from the point:
//
//   end: edge, step, free end     t ~ -theta d^p                                       theta > 0
//   jump, no wedge                t ~ -theta cos(pi alpha) d^beta                      theta > 0
//   wedge and jump, beta < 0      t ~ D/[s] - theta cos(pi alpha) d^beta               theta > 0, whatever D is
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
  enum class Is { power, constant, logarithm } is;
  Estimate<R> coefficient;  ///< theta, D/[s] or D/(1+s^2) of the table, reduced and in xi
  R power;                  ///< of d; 0 but for Is::power
  int sign;                 ///< of t next to the point; 0 where the error does not let that be decided
};

/// None at a point that is no end of contact, nor an anchor inside it. `end_error`: absolute, of the free ends, in xi.
template <Real R>
std::optional<LeadingTerm<R>> leading_term(const TractionRepresentation<R>& form, std::size_t point,
                                           const R& end_error = R(0));

/// Where the leading term pulls inside the contact: the logarithm of the distance in xi at which the local form,
/// constant and power or logarithm, changes its sign. None where it does not.
template <Real R>
std::optional<R> log_reach(const TractionRepresentation<R>& form, std::size_t point);

/// A gap over an anchor inside the contact that pulls so little far that it is known by its logarithm alone: no farther than
/// 1e30 shortest gaps, since its length is that distance but for a factor. The set with contact there is
/// the solution's but for this gap: at a distance d from it what the gap changes is smaller by a factor of the order of
/// length/d, nothing at any place that has a number of its own.
template <Real R>
struct HairlineGap {
  std::size_t anchor;
  R log_length;  ///< of its length in xi, by order of magnitude
};

/// Left to right.
template <Real R>
std::vector<HairlineGap<R>> hairline_gaps(const TractionRepresentation<R>& form, const R& end_error);

/// Does the leading term pull, and farther than over a hairline gap?
template <Real R>
bool pulls(const TractionRepresentation<R>& form, std::size_t point, const std::optional<LeadingTerm<R>>& term);

/// The supremum of t at the points where the leading term is known to pull: infinite where it blows up; 0 if none does.
/// Hairline gaps are none of them.
template <Real R>
R highest_limit(const TractionRepresentation<R>& form, const R& end_error);

/// "the leading term at x = 0 pulls: theta = -0.41 +- 3e-15", lengths in the user's unit.
template <Real R>
std::string in_words(const TractionRepresentation<R>& form, std::size_t point, const LeadingTerm<R>& term);

}  // namespace steadyslide::numeric
