#pragma once
// A point c of the surface as its neighbourhood sees it, and the equation there. x is measured from c:
//
//   H t + s t = psi_bar'   on the sides in contact, up to one power series in x, the same on both sides:
//
// what the rest of the contact does to the neighbourhood of c is analytic there. Away from contact t = 0 and the slope
// of the surface is u_bar' = H t.

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

/// What the indenter does beyond an end of contact: it ends too (an edge), goes on, or steps away from the body.
enum class Beyond { nothing, indenter, step };

struct LocalPlace {
  ContactSide contact;
  LocalSide left;
  LocalSide right;
  Beyond beyond = Beyond::indenter;  ///< of no meaning where there is contact on both sides
  /// Where the frictions are symbols: is s larger on the right? Numbers know it themselves.
  std::optional<bool> friction_increases = std::nullopt;

  bool in_contact(Side side) const;
};

/// halves/2 + left alpha_left + right alpha_right: friction 0 is that of the left side, 1 that of the right.
inline AngleForm local_exponent(int halves, int left, int right) { return {halves, {{0, left}, {1, right}}}; }

/// The field in which a place is decided, and its names for readers.
class LocalFrame {
 public:
  /// Throws std::domain_error unless each friction is a symbol, minus a symbol or a rational number.
  explicit LocalFrame(const LocalPlace& place);

  const PhaseField& field() const { return field_; }
  const PhaseField::Friction& friction(Side side) const { return field_.friction(side == Side::left ? 0 : 1); }
  /// pi, transcendental over everything else here: a symbol.
  const GiNaC::symbol& pi() const { return pi_; }
  /// Are both frictions one?
  bool one_friction() const;

  /// cot(pi lambda) and 1/sin(pi lambda) by e^{i pi lambda}. Throws std::domain_error for an integer lambda.
  LocalConstants constants(const AngleForm& lambda) const;
  /// The same in e^{i pi lambda} as written, no normal form taken.
  LocalConstants written_constants(const AngleForm& lambda) const;

  /// Absent where a friction that counts is no number.
  std::optional<Exponent> exact(const AngleForm& lambda) const;
  /// The integer below lambda for every friction allowed; absent where it depends on them.
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

/// One coefficient of the local equation of a density: holds where lhs = rhs.
struct LocalEquation {
  Formula where;
  GiNaC::ex lhs;
  GiNaC::ex rhs;
};

/// On each side in contact the coefficients of H t + s t at powers that are not analytic are zero; the coefficient of
/// x^n may be anything, but where both sides are in contact the right one less the left one is that of psi_bar'. Orders
/// beyond the slopes given are left out.
std::vector<LocalEquation> local_equations(const LocalPlace& place, const LocalConstants& constants,
                                           const LocalDensity& density);

/// Names of sides in symbols: "l", "r".
std::string suffix(Side side);

}  // namespace steadyslide::symbolic
