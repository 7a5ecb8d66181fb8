#pragma once
// Decides if a given local form satisfies the local equation. The same procedure confirms the correct form and refutes
// wrong ones. For sources of this layer, proofs_checks and tests only.

#include <ginac/ginac.h>

#include <optional>
#include <string>

#include "symbolic/field/exact_identity.hpp"
#include "symbolic/local/local_place.hpp"

namespace steadyslide::symbolic {

/// The candidate: t = density with |x|^lambda and, at an end, the slope u_bar' = outside d^lambda beyond it.
struct LocalCandidate {
  LocalPlace place;
  LocalFrame frame;  ///< of the same place; the density uses its radicals
  std::optional<AngleForm> exponent;
  LocalDensity density;
  std::optional<GiNaC::ex> outside = std::nullopt;
};

/// Makes candidates for an end: contact on one side only, at a friction jump.
class LocalEnd {
 public:
  explicit LocalEnd(Side contact, const GiNaC::ex& left = GiNaC::symbol("s_l"),
                    const GiNaC::ex& right = GiNaC::symbol("s_r"))
      : contact_(contact),
        place_{contact == Side::right ? ContactSide::right : ContactSide::left, {left}, {right}},
        frame_(place_) {}

  /// Returns t = -theta d^lambda, and the slope outside * theta d^lambda beyond the end if `outside` is given.
  LocalCandidate candidate(const AngleForm& lambda, std::optional<GiNaC::ex> outside = std::nullopt) const {
    if (outside) *outside *= theta_;
    return {place_, frame_, lambda, {{{contact_, true, 0, 0}, -theta_}}, outside};
  }
  Side contact() const { return contact_; }
  const LocalFrame& frame() const { return frame_; }
  GiNaC::ex r(Side side) const { return frame_.friction(side).r; }

 private:
  GiNaC::symbol theta_{"theta"};
  Side contact_;
  LocalPlace place_;
  LocalFrame frame_;
};

/// Returns all coefficients of the local equation and of the slope outside, as canonical text in a fixed order: lhs
/// computed from the density, rhs from the data or the candidate. Throws std::domain_error if lambda is an integer.
ExactIdentity verify_local_form(const std::string& statement, const LocalCandidate& candidate);

/// Returns the first wrong coefficient, such as "x > 0: s_l - s_r in place of 0"; empty if the form holds.
std::string first_mismatch(const LocalCandidate& candidate);

}  // namespace steadyslide::symbolic
