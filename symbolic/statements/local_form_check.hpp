#pragma once
// A local form that someone claims, put into the local equation: does it satisfy it? The same procedure confirms the
// right form and refutes wrong ones. For sources of this layer, proofs_checks and tests only.

#include <ginac/ginac.h>

#include <optional>
#include <string>

#include "symbolic/field/exact_identity.hpp"
#include "symbolic/local/local_place.hpp"

namespace steadyslide::symbolic {

/// t = density with |x|^lambda, and, at an end, the slope u_bar' = outside d^lambda that it is said to leave beyond.
struct LocalCandidate {
  LocalPlace place;
  LocalFrame frame;  ///< of the same place: its radicals are those of the density
  std::optional<AngleForm> exponent;
  LocalDensity density;
  std::optional<GiNaC::ex> outside = std::nullopt;
};

/// Contact on one side alone, under a friction jump: what an end is said to look like.
class LocalEnd {
 public:
  explicit LocalEnd(Side contact, const GiNaC::ex& left = GiNaC::symbol("s_l"),
                    const GiNaC::ex& right = GiNaC::symbol("s_r"))
      : contact_(contact),
        place_{contact == Side::right ? ContactSide::right : ContactSide::left, {left}, {right}},
        frame_(place_) {}

  /// t = -theta d^lambda, and the slope outside * theta d^lambda beyond, where one is given.
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

/// All coefficients of the local equation and of the slope outside, lhs as computed from the density, rhs as the data
/// or the candidate have it, in canonical text and in one order. Throws std::domain_error where lambda is an integer.
ExactIdentity verify_local_form(const std::string& statement, const LocalCandidate& candidate);

/// The first coefficient that is wrong: "x > 0: s_l - s_r in place of 0"; empty if the form holds.
std::string first_mismatch(const LocalCandidate& candidate);

}  // namespace steadyslide::symbolic
