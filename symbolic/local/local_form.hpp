#pragma once
// What the traction t can look like next to a point, derived from the local equation (local_place.hpp) and two signs:
// t <= 0, and the surface does not enter the indenter beyond an end of contact. Nothing is looked up: the exponent is
// the root of a characteristic determinant, named by comparing e^{2 i pi lambda} = (C + i)/(C - i), C = cot(pi lambda),
// with phases of the friction angles; amplitudes, forced constants and logarithms solve linear systems in the exact
// field. Assumed is one thing: that t is a sum of powers, with logarithms up to the second power, next to the point.
// For sources of this layer, proofs_checks and tests only. [Bal16, theorems 2, 3, 9, 10]

#include <ginac/ginac.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/truth.hpp"
#include "symbolic/local/local_place.hpp"

namespace steadyslide::symbolic {

enum class LocalKind { interior, wedge, jump, wedge_and_jump, edge, free_end, step };
std::string name_of(LocalKind kind);

/// left resp. right times x^order |x|^lambda log(|x|)^logs; without |x|^lambda unless `fractional`.
struct LocalFormTerm {
  bool fractional;
  int order;
  int logs;
  GiNaC::ex left;
  GiNaC::ex right;
  bool forced;   ///< by the slopes of the indenter; otherwise an amplitude that the whole problem decides
  Formula text;  ///< two sides: in x; one side: in the distance d
};

/// What the signs impose on data or amplitudes. `holds` is decided where the expression is a number.
struct LocalCondition {
  enum class Sign { zero, nonnegative, nonpositive };
  std::string words;
  GiNaC::ex expression;
  Sign sign;
  Formula formula;
  Truth holds;
};

/// The slope of the surface beyond an end: u_bar' = coefficient d^lambda + a power series.
struct OutsideSlope {
  GiNaC::ex coefficient;
  Formula text;
};

struct LocalForm {
  LocalPlace place;
  LocalFrame frame;  ///< the field of all expressions below: its radicals and its pi are its own
  LocalKind kind;
  std::optional<AngleForm> exponent;  ///< the leading power that is no integer, if there is one
  std::optional<GiNaC::ex> ratio;     ///< of its amplitudes, left : right, where both sides are in contact
  std::vector<LocalFormTerm> terms;   ///< three orders, the largest near the point first
  std::vector<LocalCondition> conditions;
  std::optional<OutsideSlope> outside;
  std::set<std::string> nonvanishing;  ///< where one of these vanishes, nothing is said
  GiNaC::symbol theta;                 ///< the amplitude of the leading power
  Derivation derivation;

  /// The terms as a density, for `local_equations` with the constants of `exponent`.
  LocalDensity density() const;
};

/// Throws std::domain_error for a friction outside the field, slopes of fewer than three orders, and where symbols
/// leave open which friction is larger (LocalPlace::friction_increases).
LocalForm derive_local_form(const LocalPlace& place);

}  // namespace steadyslide::symbolic
