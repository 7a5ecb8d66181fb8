#pragma once
// The local form of the traction t next to a point. It is derived from the local equation (local_place.hpp) and two
// conditions: t <= 0, and beyond an end of contact the surface does not penetrate the indenter. No result is taken from
// the literature. The exponent is the root of a characteristic determinant. It is identified by comparing e^{2 i pi
// lambda} = (C + i)/(C - i), C = cot(pi lambda), with phases of the friction angles. Amplitudes, forced constants and
// logarithms solve linear systems in the exact field. The only assumption is that next to the point t is a sum of
// powers, with logarithms up to the second power. For sources of this layer, proofs_checks and tests only. [Bal16,
// theorems 2, 3, 9, 10]

#include <ginac/ginac.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/truth.hpp"
#include "symbolic/local/local_place.hpp"

namespace steadyslide::symbolic {

/// left (for x < 0) or right (for x > 0) times x^order |x|^lambda log(|x|)^logs; without |x|^lambda unless
/// `fractional`.
struct LocalFormTerm {
  bool fractional;
  int order;
  int logs;
  GiNaC::ex left;
  GiNaC::ex right;
  bool forced;   ///< true: the indenter's slopes give it; false: an amplitude that the whole problem gives
  Formula text;  ///< for two sides in x; for one side in the distance d
};

/// A condition that the signs impose on data or amplitudes. `holds` is known if the expression is a number.
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
  LocalFrame frame;                   ///< the field of all expressions below, with its own radicals and pi
  std::optional<SingularKind> kind;   ///< absent: nothing jumps there
  std::optional<AngleForm> exponent;  ///< the leading power that is not an integer, if there is one
  std::optional<GiNaC::ex> ratio;     ///< of its amplitudes, left : right, if both sides are in contact
  std::vector<LocalFormTerm> terms;   ///< three orders, the largest near the point first
  std::vector<LocalCondition> conditions;
  std::optional<OutsideSlope> outside;
  std::set<std::string> nonvanishing;  ///< the form does not apply where one of these vanishes
  GiNaC::symbol theta;                 ///< the amplitude of the leading power
  Derivation derivation;

  /// The terms as a density, for `local_equations` with the constants of `exponent`.
  LocalDensity density() const;
};

/// Derives the local form. Throws std::domain_error if a friction is not in the field, if slopes have fewer than three
/// orders, or if the frictions are symbols and it is not given which is larger (LocalPlace::friction_increases).
LocalForm derive_local_form(const LocalPlace& place);

}  // namespace steadyslide::symbolic
