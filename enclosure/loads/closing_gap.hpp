#pragma once
// A gap that can only close. Let a solution at the load P_1 have contact K on the whole support except one gap. The gap
// lies over a wedge c without a step, with free ends e_1 < c < e_2 in the intervals beside c, and psi'' >= 0 between
// e_1 and c and between c and e_2. The indenter cannot tilt. Then for every P >= P_1 up to the load P* at which the gap
// closes there is a solution with this topology. These solutions are one branch, which depends continuously on P, and
// the gap shrinks. The steps:
//
//   gap        Where t = 0, gap'' = psi'' - (1/pi) int t/(x'-x)^2 > 0. From a free end, where gap = gap' = 0, both
//              flanks rise up to c. So for any zero of the conditions with t <= 0 the gap is > 0, and gap' ~ theta
//              d^lambda with theta > 0 at both ends.
//   branch     A change of the ends at constant load has dt = |Y| q/prod |x - e_f| with a constant q. It has no root in
//              the gap, but there the change of gap' must change its sign. So F' is regular, and the zeros are a curve.
//   pressure   Along the curve dt/dP = -t_0, A t_0 = 0 on K: t_0 = eps cos(pi alpha) |Y|/((x - e_1)(x - e_2)) q, where q
//              is linear. Its only root is in the gap, because the gap stays closed at both ends. So t_0 has one sign,
//              that of a pressure; t decreases everywhere on K and stays <= 0; and with theta > 0 both ends move into
//              the gap.
//   closing    The curve ends where e_1 or e_2 reaches c. Let kappa > 0 be a lower bound of gap''. Both flanks are
//              convex, so kappa (e_2 - c)^2/2 <= gap(c) <= (c - e_1) |[psi']|, and the same from the other side: both
//              ends reach c together. There t decreases with the load, which stays finite. So t has a limit in L^p for
//              p > 1 (t_0 has one, for all gaps). The limit solves A t = psi' on the whole support and is <= 0: it is the
//              traction of full contact.
//   until      The traction of full contact also decreases with the load. If it is positive somewhere at a load P_0, it
//              is positive there at every load up to P_0, so P* > P_0.
//
// So it is sufficient to prove the solution at P_1 and, at P_0, a place where full contact has tension. The proof needs
// no gap except the first one, and no uniqueness theorem. Above P* full contact is proved like any other contact. (In
// units of P*, the length of a gap over straight flanks and a rising friction jump is finally (C(1 - P/P*))^(1/|beta|),
// 1/|beta| from 20 on. The slope of its logarithm is 1/|beta| over the distance from the event, and intervals of loads
// would be as short as beta^2 times this distance.)

#include "enclosure/contact/contact_proof.hpp"

namespace steadyslide::enclosure {

/// Returns full contact, if the contact satisfies the assumptions above.
std::optional<ContactBox> closed_gap(const ReducedProblem& problem, const ContactBox& box);

/// Two loads that enclose the load at which full contact begins.
struct FullContactFrom {
  Rational refuted;                ///< full contact has tension somewhere at this load, and at smaller ones
  std::optional<Rational> proved;  ///< at this load it has no tension; absent if it has at all loads, or undecided
};

/// Returns two such loads between `from` and `to`, with a distance of at most `width` times the load. Neither of them
/// is `from` or `to`. Both hold only as far as the loads can be decided. Absent if full contact is not refuted at
/// `from`.
std::optional<FullContactFrom> full_contact_from(const ReducedProblem& problem, const ContactBox& full,
                                                 const Rational& from, const Rational& to, const Rational& width,
                                                 JacobiRules& rules, WorkBudget& work);

}  // namespace steadyslide::enclosure
