#pragma once
// The neighbourhood of a point c of the surface, and the equation there. x is measured from c:
//
//   H t + s t = psi_bar'   on the sides in contact, up to one power series in x, the same on both sides:
//
// the rest of the contact contributes a function that is analytic near c. Away from contact t = 0, and the slope of the
// surface is u_bar' = H t.

#include <ginac/ginac.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/exponent.hpp"
#include "model/singular_point.hpp"
#include "symbolic/field/formula_text.hpp"
#include "symbolic/field/phase_field.hpp"
#include "symbolic/local/local_action.hpp"

namespace steadyslide::symbolic {

/// One side of c: s = +-gamma f, a symbol or a rational number, and psi_bar' = slopes[0] + slopes[1] x + slopes[2] x^2.
struct LocalSide {
  GiNaC::ex friction;
  std::vector<GiNaC::ex> slopes = {0, 0, 0};
};

/// The indenter beyond an end of contact: it ends too (an edge), continues, or steps away from the body.
enum class Beyond { nothing, indenter, step };

struct LocalPlace {
  ContactSide contact;
  LocalSide left;
  LocalSide right;
  Beyond beyond = Beyond::indenter;  ///< ignored if there is contact on both sides
  /// For frictions that are symbols: true if s is larger on the right. Not used for numbers.
  std::optional<bool> friction_increases = std::nullopt;

  bool in_contact(Side side) const;
};

/// Returns halves/2 + left alpha_left + right alpha_right. Friction 0 is on the left side, friction 1 on the right.
inline AngleForm local_exponent(int halves, int left, int right) { return {halves, {{0, left}, {1, right}}}; }

/// The field in which statements on a place are decided, and its names for readers.
class LocalFrame {
 public:
  /// Throws std::domain_error unless each friction is a symbol, minus a symbol or a rational number.
  explicit LocalFrame(const LocalPlace& place);

  const PhaseField& field() const { return field_; }
  const PhaseField::Friction& friction(Side side) const { return field_.friction(side == Side::left ? 0 : 1); }
  /// pi, as a symbol, because it is transcendental over the other elements.
  const GiNaC::symbol& pi() const { return pi_; }
  /// True if both frictions are equal.
  bool one_friction() const;

  /// Returns cot(pi lambda) and 1/sin(pi lambda), computed from e^{i pi lambda}. Throws std::domain_error if lambda is
  /// an integer.
  LocalConstants constants(const AngleForm& lambda) const;
  /// Returns the same in terms of e^{i pi lambda}, without a normal form.
  LocalConstants written_constants(const AngleForm& lambda) const;

  /// Returns lambda as a number; absent if it depends on a friction that is a symbol.
  std::optional<Exponent> exact(const AngleForm& lambda) const;
  /// Returns the integer part of lambda if it is the same for all admissible frictions; otherwise absent.
  std::optional<int> floor(const AngleForm& lambda, std::optional<bool> friction_increases) const;

  Formula text(const AngleForm& lambda) const;
  Formula text(const GiNaC::ex& element) const;
  Formula times(const GiNaC::ex& element, const Formula& factor) const;
  const LatexNames& names() const { return names_; }

 private:
  std::array<GiNaC::ex, 2> s_;
  PhaseField field_;
  GiNaC::symbol pi_;
  LatexNames names_;
};

/// One coefficient of the local equation of a density. The equation holds if lhs = rhs.
struct LocalEquation {
  Formula where;
  GiNaC::ex lhs;
  GiNaC::ex rhs;
};

/// Returns the local equations. On each side in contact, the coefficients of H t + s t at powers that are not analytic
/// must be zero. The coefficient of x^n is arbitrary; if both sides are in contact, the right one minus the left one
/// must equal the jump of the coefficient of psi_bar'. Orders beyond the given slopes are left out.
std::vector<LocalEquation> local_equations(const LocalPlace& place, const LocalConstants& constants,
                                           const LocalDensity& density);

/// Names of sides in symbols: "l", "r".
std::string suffix(Side side);

}  // namespace steadyslide::symbolic
