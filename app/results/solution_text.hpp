#pragma once
// A solution as the texts that results show. From here on, no code depends on the precision.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/results/field_text.hpp"
#include "library/answer/quantities.hpp"
#include "library/problem_file/problem_file.hpp"
#include "library/solve/failed_condition.hpp"
#include "library/text/number_format.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::app {

using namespace library;

/// One number, or two if the limits from left and right differ. Here and below, an empty text means NaN or not known.
struct LimitText {
  NumberText left;
  NumberText right;
  bool apart = false;  ///< true: show two numbers, even if they are equal

  bool two_sided() const { return apart || left.value != right.value; }
};

struct SampleText {
  std::string x;
  LimitText traction;
  LimitText shear;
  NumberText gap;  ///< also empty outside the support
  LimitText slope;
  NumberText displacement{};
  LimitText shear_slope{};
  NumberText cumulative_load{};
  std::pair<std::string, std::string> friction{};  ///< on the left and on the right; also empty outside the support

  /// True if it needs two rows.
  bool two_sided() const {
    return traction.two_sided() || shear.two_sided() || slope.two_sided() || shear_slope.two_sided() ||
           friction.first != friction.second;
  }
};

struct EndText {
  NumberText x;
  std::string kind;
  std::string exponent;
  NumberText intensity;
};

struct SingularText {
  NumberText x;
  std::string kind;
  ExponentText exponent;
  NumberText intensity;
  NumberText constant;
  LimitText stress_intensity{};  ///< two numbers at a jump, one elsewhere
  std::string unit{};            ///< unit of the stress intensity; empty for a logarithm
  bool infinite = false;         ///< the pressure is infinite there if the intensity is positive
};

/// The exponent of the largest pressure is a text, "log" for a logarithm.
using ResultantsText = answer::ResultantsOf<NumberText, std::string>;

/// The tolerances of `solve --tolerance-profile` and `--tolerance-friction`.
struct Tolerance {
  Rational profile;   ///< largest change of the profile, in units of length
  Rational friction;  ///< largest change of the friction coefficient
};

/// The ends of an interval, rounded outwards.
struct IntervalText {
  std::string from;
  std::string to;
};

struct ToleranceText {
  std::string profile;
  std::string friction;
  bool proved = false;  ///< false: the intervals rest on estimates of the solution
  std::string energy;   ///< E, an upper bound (enclosure/loads/tolerance_band.hpp)
  std::vector<IntervalText> load_share;
  IntervalText friction_force;
  IntervalText effective_friction;
};

/// Returns the intervals around the solved quantities. A quantity that is not known does not narrow its interval. Throws
/// InvalidData if s = +-gamma f decreases towards +x.
ToleranceText tolerance_text(const ContactProblem& problem, const Tolerance& tolerance, const ResultantsText& solved);

/// The size of a named quantity.
struct NamedSize {
  std::string name;
  std::string size;
};

/// The words for a solution whose problem a theorem on uniqueness covers (docs/theory.md), and for one without a theorem.
inline constexpr const char* only_solution = "the only solution";
inline constexpr const char* no_uniqueness = "on this body uniqueness is proved for constant friction alone";

/// The result of a proof, if one was requested.
struct ProofText {
  bool proved = false;
  std::string reason;  ///< the reason of a failure; `x` is its place, if it has one
  std::string x;
  long bits = 0;              ///< bits of the balls
  std::size_t intervals = 0;  ///< number of intervals on which signs were decided
  std::string certificate;    ///< certificate of a proved solution, docs/certified.md

  /// "reason; x = ..."
  std::string why_not() const { return x.empty() ? reason : reason + "; x = " + x; }
};

/// The proved bounds for pressures on cells, if requested (enclosure/cells/cell_bound.hpp).
struct BoundText {
  bool proved = false;
  std::string reason;  ///< the reason of a failure
  std::size_t cells = 0;
  std::string energy;       ///< upper bound of the error's energy, in units of c P^2
  std::string largest_gap;  ///< the largest gap under pressure, in units of c P
  std::string certificate;  ///< docs/certified.md
};

/// Equal cells between two places of x.
struct CellsText {
  std::size_t count;
  NumberText from, to;
};

struct SolutionText {
  std::string method;
  std::optional<CellsText> cells;  ///< of a solution on cells
  std::string instead;             ///< not empty: another method failed before; the reason
  int digits = 0;
  std::vector<std::pair<EndText, EndText>> contact;
  std::vector<NumberText> width, component_load;  ///< one for each contact component
  std::vector<SingularText> singular_points;
  ResultantsText resultants;
  std::vector<SampleText> samples;
  FieldText field;
  std::vector<SampleText> curve;  ///< for a picture, left to right; from the solver even if the rest is proved
  std::vector<NamedSize> errors;  ///< relative; estimated, or proved if the solution is proved
  std::vector<NamedSize> residuals;
  std::string uniqueness;        ///< the theorem that says so; empty if none does
  std::string reason;            ///< not empty: the method does not apply, and the other members are empty
  std::string failed_condition;  ///< not empty: this is not a solution; the reason
  std::vector<std::string> warnings;
  bool in_range = true;                    ///< false: some value is NaN, or near the end of the range of its type
  std::optional<ProofText> proof;          ///< absent if not requested
  std::optional<BoundText> bound;          ///< the same for a solution on cells
  std::optional<ToleranceText> tolerance;  ///< absent if not requested

  bool is_solved() const { return reason.empty() && failed_condition.empty(); }
};

inline const char* name_of(Sliding sliding) { return sliding == Sliding::plus_x ? "+x" : "-x"; }
inline Sliding opposite(Sliding sliding) { return sliding == Sliding::plus_x ? Sliding::minus_x : Sliding::plus_x; }

/// A proof for all loads between two consecutive loads.
struct StretchText {
  std::string from;
  std::string to;
  std::string status;  ///< proved, event or open
  std::string words;   ///< the event, or the reason why nothing is proved

  bool is_proved() const { return status == "proved"; }
  bool is_open() const { return status == "open"; }
};

/// The requested parts of a solution, and the limit for its residuals.
struct SolutionWanted {
  int digits = 16;
  std::vector<Rational> at{};  ///< the places of samples,
  int samples = 0;             ///< and the number of samples in each component and gap
  FieldWanted field{};
  std::optional<Rational> over{};  ///< the length of the window of averages
  bool curve = false;              ///< samples for a picture, 400 a component if there are few components
  /// Entries of the result (solve_json.hpp) that become texts; other texts stay empty. Empty list: all entries.
  /// Everything is computed in any case.
  std::vector<std::string> entries{};
  /// A state with a larger residual is not a solution. Infinite for a method whose failed_condition() judges its
  /// residuals itself; absent: library::largest_residual_of.
  std::optional<double> largest_residual{};
};

/// Sets the ends of contact. `texts` makes texts of numbers with number() and intensity(); `told()` is false if texts
/// stay empty.
template <class Number, class Texts>
void set_contact(SolutionText& text, const std::vector<ContactComponentOf<Number>>& contact, Texts& texts) {
  text.contact.clear();
  text.width.clear();
  const auto end_text = [&](const ContactEndOf<Number>& end) {
    return EndText{texts.number(end.x), std::string(name_of(end.kind)),
                   texts.told() ? format_exponent(end.exponent, texts.digits()) : "", texts.intensity(end.intensity)};
  };
  for (const ContactComponentOf<Number>& component : contact) {
    text.contact.emplace_back(end_text(component.left), end_text(component.right));
    text.width.push_back(texts.number(component.width));
  }
}

/// Limits of which one is infinite. If the function is infinite from one side only, at an edge, there is one infinite
/// text. Infinities of both signs are two texts. A finite and an infinite limit are two texts if the traction is
/// infinite.
LimitText infinite_limits(const LimitText& limits, const LimitText& traction);
/// Two numbers at a jump; at an end one, for the side in contact.
LimitText stress_intensity_text(SingularKind kind, const NumberText& left, const NumberText& right);

/// The same as set_contact() for singular points.
template <class Number, class Texts>
void set_singular_points(SolutionText& text, const std::vector<SingularPointOf<Number>>& points, Texts& texts) {
  text.singular_points.clear();
  for (const SingularPointOf<Number>& point : points) {
    const auto side_text = [&](const std::optional<Number>& k) { return k ? texts.intensity(*k) : NumberText{}; };
    const auto& [left, right] = point.stress_intensity;
    const bool has_unit = texts.told() && point.exponent;
    text.singular_points.push_back({texts.number(point.x), std::string(name_of(point.kind)),
                                    texts.told() ? exponent_text(point.exponent, texts.digits()) : ExponentText{},
                                    texts.intensity(point.intensity), texts.number(point.constant),
                                    stress_intensity_text(point.kind, side_text(left), side_text(right)),
                                    has_unit ? stress_intensity_unit(*point.exponent) : "",
                                    local_terms(point.kind).is_infinite(point.exponent)});
  }
}

template <numeric::Real R>
SolutionText solution_text(const Problem& problem, const numeric::ContactSolution<R>& solution,
                           const SolutionWanted& wanted);

/// The limits as one number if they differ by no more than their errors, otherwise as two. If the function is infinite
/// from one side only, at an edge, there is one infinite text. With `apart`, both limits are kept for files even if
/// they agree; a person sees one number.
template <numeric::Real R>
LimitText limit_text(const numeric::TwoSided<R>& limits, const numeric::TwoSided<R>& traction, int digits,
                     bool apart = false);

}  // namespace steadyslide::app
