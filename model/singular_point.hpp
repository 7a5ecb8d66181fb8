#pragma once
// The places where the normal traction can be singular, and the power of the distance at each. [Bal16, theorems 2 and
// 3]
//
// Powers are taken with the friction on the contact side, s = +-gamma f, alpha = arctan(s)/pi:
//   left end of contact:   edge -(1/2 + alpha), free  1/2 - alpha
//   right end of contact:  edge -(1/2 - alpha), free  1/2 + alpha
//   friction jump inside the contact: beta = alpha(c-) - alpha(c+); wedge without jump: logarithm.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "model/contact_problem.hpp"
#include "model/exponent.hpp"

namespace steadyslide {

Exponent edge_exponent(End end, const Rational& s);
Exponent free_exponent(End end, const Rational& s);
/// Returns beta [Bal16, (7)]. It is negative (the traction blows up) where s increases to the right, and zero where s
/// does not change.
Exponent jump_exponent(const Rational& s_left, const Rational& s_right);

enum class SingularKind { edge, free, step, friction_jump, wedge, wedge_and_jump };

/// The terms of the traction beside a singular point of one kind. [Bal16, theorems 2 and 3]
struct LocalTerms {
  SingularKind kind;
  std::string_view name;   ///< in the interface and in files
  std::string_view words;  ///< in sentences
  std::string_view form;   ///< for readers; empty if it is that of another kind
  bool is_end;             ///< contact ends there; otherwise there is contact on both sides
  bool friction_jumps;     ///< the friction changes there
  int derivative;          ///< the lowest derivative of the profile that jumps there, 1 for the slope; 0: none
  bool has_power;          ///< the traction has a power of the distance
  bool has_logarithm;      ///< the traction has a logarithm of the distance
  bool has_constant;       ///< the traction has a constant besides

  /// True if the traction is infinite beside a point with this exponent and a positive intensity.
  bool is_infinite(const std::optional<Exponent>& exponent) const {
    return exponent ? exponent->sign() < 0 : has_logarithm;
  }
};
/// Returns the terms of all kinds, in the order of SingularKind.
std::span<const LocalTerms> all_local_terms();
const LocalTerms& local_terms(SingularKind kind);
inline std::string_view name_of(SingularKind kind) { return local_terms(kind).name; }
/// Returns the kind of an end of contact, where the traction vanishes or not.
inline SingularKind end_kind(bool vanishes, bool at_end_of_support) {
  return vanishes ? SingularKind::free : at_end_of_support ? SingularKind::edge : SingularKind::step;
}
/// Returns the kind of a point inside the contact where this derivative of the profile is the lowest that jumps, 0 for
/// none; absent if the traction is not singular.
std::optional<SingularKind> inner_kind(bool friction_jumps, int derivative);

/// The exact terms of the traction at a point c inside the contact where something jumps, in reduced quantities:
///   t ~ constant - theta cos(pi alpha) |x - c|^beta   or   t ~ constant + logarithm log|x - c|/pi.
/// theta, and the constant beside a logarithm, depend on the whole contact and are not known here.
struct InnerTerms {
  SingularKind kind;
  Rational logarithm = 0;
  Rational constant = 0;
};
/// Returns the terms where s and the profile jump like this; absent if neither s nor the slope jumps.
std::optional<InnerTerms> inner_terms(const Rational& s_left, const Rational& s_right, const Indenter::Break& at);

enum class ContactSide { left, right, both };
std::string_view name_of(ContactSide side);

struct SingularPoint {
  std::optional<Rational> x;  ///< absent: anywhere under the given friction value
  SingularKind kind;
  ContactSide contact;               ///< the side of x on which there is contact
  std::vector<Rational> friction;    ///< f on the contact side, or left and right of x
  std::optional<Exponent> exponent;  ///< absent: logarithm
};

/// Returns every place where the traction can be singular for these data, for any contact zone: from left to right,
/// then the free ends that can lie anywhere. Places where nothing jumps (height zero) and the edges of an elastic
/// indenter are left out.
std::vector<SingularPoint> possible_singular_points(const ContactProblem& problem);

}  // namespace steadyslide
