// What no calculation decides: statements by compactness or in spaces of distributions, or whose text is not at hand.
// [Bal16, theorems 1, 16, 17, 23-25]

#include "proofs_checks/claims/claims.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> beyond_calculation_claims() {
  std::vector<Claim> claims;
  claims.push_back(claim_beyond_calculation(
      {"thm-01-existence", "[Bal16, theorem 1], existence",
       "For every load `P > 0`, every piecewise Lipschitz profile `psi_bar` and every piecewise constant friction `f "
       ">= 0` there are a measure `t_n` and a displacement `u_bar_n in H^{1/2}` with `A t_n = u_bar_n'`, `u_bar_n + C "
       "<= psi_bar`, `t_n <= 0`, `t_n (u_bar_n + C - psi_bar) = 0` and `int_{-1}^1 t_n = -P`.",
       "`-1 < nu < 1/2`, one support `[-1, 1]`",
       "The paper adapts the proofs of its theorems 16 and 23, of section 4. Where `f` jumps, the term `(s_k - "
       "s_{k-1}) T(c_k)^2/2` of the energy is not bounded in `H^{-1/2}`, and where `f` falls it is negative: the "
       "theorem of Lions and Stampacchia does not apply. On cells the same statement is a theorem on strictly "
       "copositive matrices, which gives no bound that is independent of the cells."},
      {"existence for all data in a space of measures: a limit of approximations by compactness, which examples do not "
       "replace",
       {"vi-discrete-existence", "rh-form", "rh-count", "vi-convergence-jump-up", "vi-convergence-jump-down",
        "vi-convergence-three-jumps", "thm-01-uniqueness-on-cells"}}));
  claims.push_back(claim_beyond_calculation(
      {"thm-16", "[Bal16, theorem 16], cited in the proof of theorem 1",
       "Existence for one friction jump, of section 4: theorem 1's existence is said to follow from it and from "
       "theorem 23 by a straightforward adaptation.",
       "`s(x) = s_-` for `x < 0`, `s_+` for `x > 0`; the exact statement is not known here",
       "The text at hand ends where section 4 begins. What is known is the problem, `A t_n = u_bar_n'` with one jump "
       "at `0`, and the use that theorem 1 makes of the result."},
      {"its statement and proof are not in the text at hand; what theorem 1 needs of it is existence",
       {"vi-discrete-existence", "vi-convergence-jump-up", "vi-convergence-jump-down", "rh-form"}}));
  claims.push_back(claim_beyond_calculation(
      {"thm-17", "[Bal16, theorem 17], cited in the proof of theorem 2",
       "The form of the traction at a friction jump inside the contact, of section 4: theorem 2 is said to follow from "
       "it, from theorem 9 and from theorem 24.",
       "`s(x) = s_-` for `x < 0`, `s_+` for `x > 0`; the exact statement is not known here",
       "The text at hand ends where section 4 begins. The remainder in theorem 2 is `|x-c|^beta` times a continuous "
       "function for every solution and every piecewise Lipschitz profile, a statement on regularity. For piecewise "
       "polynomial profiles the form is derived here, with an analytic remainder."},
      {"its statement and proof are not in the text at hand, and regularity for all profiles is no calculation",
       {"thm-02-local-forms", "thm-02-solved-wedge-and-jump", "thm-09-solved-wedge",
        "vi-convergence-wedge-and-jump"}}));
  claims.push_back(claim_beyond_calculation(
      {"thm-23", "[Bal16, theorem 23], cited in the proof of theorem 1",
       "Of section 4, the second of the two theorems from which theorem 1 is said to follow: by that role, uniqueness "
       "where `f` is nondecreasing, or existence where theorem 16 does not reach.",
       "the exact statement is not known here",
       "The text at hand ends where section 4 begins. Two solutions differ by a traction `t` of zero mean with `b(t, "
       "t) <= 0`; with `b(t, t) = -(1/pi) <<t * log|x|, t>> + sum_k (s_k - s_{k-1}) T(c_k)^2/2` and rising `s` that "
       "leaves `t = 0`. In `H^{-1/2}` the values `T(c_k)` have no meaning: to give them one is what the theorem has to "
       "do."},
      {"its statement and proof are not in the text at hand",
       {"energy-identity", "vi-energy-identity", "vi-definite-rising", "thm-01-uniqueness-on-cells",
        "vi-discrete-existence"}}));
  claims.push_back(claim_beyond_calculation(
      {"thm-24", "[Bal16, theorem 24], cited in the proof of theorem 2",
       "Of section 4, one of the three theorems from which the local forms of theorem 2 are said to follow.",
       "the exact statement is not known here",
       "The text at hand ends where section 4 begins. What theorem 2 says of any solution is checked on solved "
       "problems: the powers, the constants and the logarithms at jumps and wedges inside the contact."},
      {"its statement and proof are not in the text at hand",
       {"thm-02-local-forms", "thm-02-solved-wedge-and-jump", "thm-09-solved-wedge", "vi-convergence-jump-up",
        "vi-convergence-wedge"}}));
  claims.push_back(claim_beyond_calculation(
      {"thm-25", "[Bal16, theorem 25, appendix A]: the theorem of Lions and Stampacchia with a functional",
       "For a continuous and coercive form `a`, not necessarily symmetric, on a Hilbert space, and a proper, convex "
       "and lower semicontinuous functional `phi`, there is exactly one `u` with `a(u_hat-u, u) + phi(u_hat) - phi(u) "
       ">= 0` for all `u_hat`.",
       "as section 3.2 uses it; the appendix is not in the text at hand",
       "Uniqueness takes two lines: of two solutions `u_1`, `u_2` each is put into the other's inequality, and the sum "
       "is `-a(u_1-u_2, u_1-u_2) >= 0`. Existence is that of a fixed point of `u -> u_hat`, the proximal point of `u` "
       "moved against `a`, a contraction for small steps. Propositions 6 and 7 apply it to `b`, with the indicator of "
       "`K_0'`, and to `a`, with `phi` of (13); its assumptions there and its conclusions on discretisations are "
       "checked."},
      {"a theorem on all Hilbert spaces, by an abstract argument",
       {"lemma-04-functional", "sec-32-form-a", "prop-05-equivalence", "prop-06-problem-I0", "prop-07-problem-I",
        "prop-07-problems-linked", "thm-08-homogeneous"}}));
  return claims;
}

}  // namespace steadyslide::proofs_checks
