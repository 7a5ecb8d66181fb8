// The statements that the symbolic layer derives and decides: local forms, the Riemann-Hilbert problem, closed forms as
// theorems, the energy. A claim takes several of them together; each brings at least four wrong variants, which the
// same decision has to refute.

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>

#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/claims/identities.hpp"
#include "symbolic/energy_identity.hpp"
#include "symbolic/local_form_statements.hpp"
#include "symbolic/riemann_hilbert_statements.hpp"

namespace steadyslide::proofs_checks {
namespace {

using Statements = std::vector<symbolic::DecidedStatement>;
/// Computed when a claim first needs them, and once: deciding all takes seconds.
using Source = const Statements& (*)();

const Statements& local_forms() {
  static const Statements all = symbolic::local_form_statements();
  return all;
}

const Statements& riemann_hilbert() {
  static const Statements all = symbolic::riemann_hilbert_statements();
  return all;
}

const Statements& energy() {
  static const Statements all = symbolic::energy_statements();
  return all;
}

/// The statements whose ids start with one of the prefixes, and which variant of each is examined: the right one
/// (absent) or a wrong one; the last choice takes all wrong variants from its number on.
struct Selection {
  Source source;
  std::vector<std::string> prefixes;
  std::optional<std::size_t> wrong;
};

constexpr std::size_t variants = 4;

bool is_selected(const std::string& id, const std::vector<std::string>& prefixes) {
  return std::ranges::any_of(prefixes, [&](const std::string& prefix) { return id.starts_with(prefix); });
}

/// The wrong variants count as refuted only if every one of every statement is.
std::vector<Evidence> examine_wrong(const Statements& chosen, std::size_t first) {
  std::size_t refuted = 0;
  for (const symbolic::DecidedStatement& statement : chosen) {
    const auto& controls = statement.controls;
    const std::size_t end = first + 1 < variants ? std::min(first + 1, controls.size()) : controls.size();
    if (first >= end) throw std::logic_error(statement.id + " has too few wrong variants");
    for (std::size_t k = first; k < end; ++k, ++refuted) {
      if (controls[k].identical) {
        return {ExactIdentity{"a wrong variant is not refuted: " + controls[k].statement, {}, {}}};
      }
    }
  }
  const symbolic::ExactIdentity& example = chosen.front().controls[first];
  return {Counterexample{"generic parameters", std::to_string(refuted) +
                                                   " wrong variants are other functions, for example \"" +
                                                   example.statement + "\": " + example.lhs + " and " + example.rhs}};
}

std::vector<Evidence> check_statements(const Context& /*context*/, const Selection& selection) {
  Statements chosen;
  for (const symbolic::DecidedStatement& statement : selection.source()) {
    if (is_selected(statement.id, selection.prefixes)) chosen.push_back(statement);
  }
  if (chosen.empty()) throw std::logic_error("no statement is named " + selection.prefixes.front());
  if (selection.wrong) return examine_wrong(chosen, *selection.wrong);
  return {weigh_identities(right_identities(chosen),
                           "decided in Q(s, r, i), r^2 = 1 + s^2, for symbols s; nothing is evaluated")};
}

Claim decided(ClaimText text, Source source, std::vector<std::string> prefixes) {
  std::vector<Wrong<Selection>> wrong;
  for (std::size_t k = 0; k < variants; ++k) {
    wrong.push_back({k + 1 < variants ? "wrong variant " + std::to_string(k + 1) + " of each statement"
                                      : "all other wrong variants of each statement",
                     {source, prefixes, k}});
  }
  return make_claim<Selection>(std::move(text), check_statements, {source, prefixes, std::nullopt}, std::move(wrong));
}

constexpr const char* local = "contact next to the point as said; t a sum of powers there, with logarithms";

}  // namespace

std::vector<Claim> derivation_claims() {
  std::vector<Claim> claims;
  claims.push_back(decided({"thm-02-local-forms", "[Bal16, theorem 2]: traction next to a jump, a wedge, both",
                            "the local equation leaves -theta |x-c|^beta cos(pi alpha) at a jump, with the constant "
                            "[psi']/[s] at a wedge and jump, and forces [psi']/(1+s^2) (log|x-c|/pi + s H(x-c)) at a "
                            "wedge",
                            local},
                           local_forms, {"theorem-2-"}));
  claims.push_back(
      decided({"thm-03-local-forms", "[Bal16, theorem 3]: traction and slope at the ends of contact",
               "powers -1/2-alpha, -1/2+alpha at edges and steps, 1/2-alpha, 1/2+alpha at free ends, alpha "
               "on the contact side; u' beyond has sqrt(1+s^2) times the amplitude",
               local},
              local_forms, {"theorem-3-"}));
  claims.push_back(decided({"thm-09-local-forms", "[Bal16, theorem 9]: the logarithm at a wedge",
                            "t = D(x)/(1+s^2) (log|x-c|/pi + s H(x-c)) + analytic: the logarithms stop with the degree "
                            "of D",
                            local},
                           local_forms, {"theorem-9"}));
  claims.push_back(decided({"thm-10-local-forms", "[Bal16, theorem 10]: the ends of contact under constant friction",
                            "theorem 3 under one friction", local},
                           local_forms, {"theorem-10-"}));
  claims.push_back(decided({"thm-36-exponents", "[Bal16, theorem 36], reconstructed: the Riemann-Hilbert problem",
                            "Phi+ = G Phi- + psi'/(s+i), G = (s-i)/(s+i); the exponents of Y follow from G, and Y+ = G "
                            "Y- on every panel",
                            "up to three components, up to four jumps; symbolic and rational friction"},
                           riemann_hilbert,
                           {"rh-plemelj", "rh-exponent-left", "rh-exponent-right", "rh-exponent-jump", "rh-Y-"}));
  claims.push_back(decided({"thm-36-general-solution", "[Bal16, theorem 36], reconstructed: its solution",
                            "the exponents sum to (free ends) - (components); (s+i)Y+ = epsilon |Y|/cos(pi alpha), "
                            "epsilon = +-1; the general solution; as many unknowns as conditions",
                            "any number of jumps and components"},
                           riemann_hilbert, {"rh-exponent-sum", "rh-real", "rh-general-solution", "rh-count"}));
  claims.push_back(decided({"thm-36-polynomial-profile", "derived from [Bal16, theorem 36]: polynomial profiles",
                            "with Q the polynomial part of psi'/Y at infinity, t = epsilon cos(pi alpha)|Y| (Q + q)",
                            "psi' one polynomial on the whole contact"},
                           riemann_hilbert, {"rh-polynomial-", "rh-power-sums"}));
  claims.push_back(decided({"eq-04-derived", "[Bal16, (4) and (8)]: flat punch under constant friction",
                            "the formulas are what the general solution gives", "full contact"},
                           riemann_hilbert, {"rh-flat-punch-0", "rh-kernel"}));
  claims.push_back(decided({"eq-05-07-derived", "[Bal16, (5)-(7)]: flat punch with a friction jump; up to four jumps",
                            "the formula is what the general solution gives", "full contact"},
                           riemann_hilbert,
                           {"rh-flat-punch-1", "rh-flat-punch-2", "rh-flat-punch-3", "rh-flat-punch-4"}));
  claims.push_back(decided({"eq-10-derived", "[Bal16, (10)]: the inverse of the operator",
                            "formula (10) and the polynomial form agree for u' = 1, x, ..., x^4, with 0, 1 and 3 jumps",
                            "polynomial u' to the fourth degree"},
                           riemann_hilbert, {"rh-inversion-"}));
  claims.push_back(
      decided({"tilted-punch-derived", "derived: the tilted flat punch, with up to four jumps",
               "N = delta (x + sigma_1) - P/pi; an edge lifts at delta = P/(pi (e + sigma_1)), e that edge",
               "full contact up to that tilt"},
              riemann_hilbert, {"rh-tilted-punch", "rh-lifting-"}));
  claims.push_back(decided({"parabola-derived", "[Bal16, section 2]: Galin's parabola, and jumps inside its contact",
                            "half-width, zone, peak and both amplitudes; sum p r = 0, sum p r^2 = 2PR/pi; one and two "
                            "edges",
                            "one component"},
                           riemann_hilbert, {"rh-parabola-"}));
  claims.push_back(
      decided({"quartic-derived", "derived: the quartic",
               "psi' = kappa x^3: N = kappa (x^2 + sigma_1 x + h_2), h_3 = 0, kappa h_4 = P/pi", "free ends"},
              riemann_hilbert, {"rh-quartic"}));
  claims.push_back(decided({"energy-identity", "[Bal16, sections 3.1 and 4]: the energy of a traction of zero mean",
                            "b(t,t) = -(1/pi)<t*log|x|, t> + 1/2 sum (s_k - s_{k-1}) T(c_k)^2; the sign form is skew",
                            "polynomial and Chebyshev-weighted tractions of zero mean"},
                           energy, {"energy-"}));
  return claims;
}

}  // namespace steadyslide::proofs_checks
