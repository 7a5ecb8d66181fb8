#pragma once
// A solution as the texts that results show: the precision ends here, the writers see no numbers.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/results/field_text.hpp"
#include "library/answer/quantities.hpp"
#include "library/problem_file/problem_file.hpp"
#include "library/solve/failed_condition.hpp"
#include "library/text/number_format.hpp"
#include "model/uniqueness.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::app {

using namespace library;

/// One number, or two where the limits from left and right differ. An empty text, here and below: no number, or not
/// known.
struct LimitText {
  NumberText left;
  NumberText right;
  bool apart = false;  ///< two numbers, also where they are equal

  bool two_sided() const { return apart || left.value != right.value; }
};

struct SampleText {
  std::string x;
  LimitText traction;
  LimitText shear;
  NumberText gap;  ///< empty outside the support, too
  LimitText slope;
  NumberText displacement{};
  LimitText shear_slope{};
  NumberText cumulative_load{};
  std::pair<std::string, std::string> friction{};  ///< on the left and on the right; empty outside the support, too

  /// Does it take two rows?
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
  LimitText stress_intensity{};  ///< at a jump two, else one
  std::string unit{};            ///< of the stress intensity; empty for a logarithm
};

/// The exponent of the largest pressure is a text, "log" for a logarithm.
using ResultantsText = answer::ResultantsOf<NumberText, std::string>;

/// The size of something that has a name.
struct NamedSize {
  std::string name;
  std::string size;
};

/// What theorem 1 of the paper says of a solution where Uniqueness::proved.
inline constexpr const char* unique_by_theorem = "unique by theorem 1 of [Bal16]";

/// What was proved of a solution, where that was asked for.
struct ProofText {
  bool proved = false;
  std::string reason;  ///< why not, and where: x, if it is about a place
  std::string x;
  long bits = 0;              ///< of the balls
  std::size_t intervals = 0;  ///< on which signs were decided
  std::string certificate;    ///< of a proved solution, docs/certificate.md

  /// "reason; x = ..."
  std::string why_not() const { return x.empty() ? reason : reason + "; x = " + x; }
};

/// What was proved of pressures on cells, where that was asked for (enclosure/cells/cell_bound.hpp).
struct BoundText {
  bool proved = false;
  std::string reason;  ///< why not
  std::size_t cells = 0;
  std::string energy;       ///< of the error, in units of c P^2: an upper bound
  std::string largest_gap;  ///< under pressure, in units of c P
  std::string certificate;  ///< docs/certificate.md
};

struct SolutionText {
  std::string method;
  std::string instead;  ///< not empty: the method took the place of another one, and why
  int digits = 0;
  std::vector<std::pair<EndText, EndText>> contact;
  std::vector<NumberText> width, component_load;  ///< of each contact component
  std::vector<SingularText> singular_points;
  ResultantsText resultants;
  std::vector<SampleText> samples;
  FieldText field;
  std::vector<SampleText> curve;  ///< for a picture, left to right; of the solver where the rest is proved
  std::vector<NamedSize> errors;  ///< estimated, relative; proved where the solution is
  std::vector<NamedSize> residuals;
  Uniqueness uniqueness;
  std::string reason;            ///< not empty: the method does not apply, and nothing else is here
  std::string failed_condition;  ///< not empty: not a solution, and why
  std::vector<std::string> warnings;
  bool in_range = true;            ///< false: some value is no number, or near the end of the range of its type
  std::optional<ProofText> proof;  ///< absent: not asked for
  std::optional<BoundText> bound;  ///< the same, on cells

  bool is_solved() const { return reason.empty() && failed_condition.empty(); }
};

inline const char* name_of(Sliding sliding) { return sliding == Sliding::plus_x ? "+x" : "-x"; }
inline Sliding opposite(Sliding sliding) { return sliding == Sliding::plus_x ? Sliding::minus_x : Sliding::plus_x; }

/// What is proved of the loads between two that follow each other.
struct StretchText {
  std::string from;
  std::string to;
  std::string status;  ///< proved, event or open
  std::string words;   ///< what happens, or why nothing is proved

  bool is_proved() const { return status == "proved"; }
  bool is_open() const { return status == "open"; }
};

/// What of a solution is told, and what makes it one.
struct SolutionWanted {
  int digits = 16;
  std::vector<Rational> at{};  ///< samples at these places,
  int samples = 0;             ///< and so many a component and a gap
  FieldWanted field{};
  bool curve = false;  ///< as many as a picture needs, 400 a component where these are few
  /// Entries of the result (solve_json.hpp) that are told; the texts of others stay empty. None: all. All is computed.
  std::vector<std::string> entries{};
  /// A solution with a larger residual is none. Infinite for a method whose own failed_condition() weighs its residuals.
  double largest_residual = library::largest_residual;
};

/// Sets the ends of contact. `texts` makes texts of numbers: number(), intensity(); `told()` is false where they stay empty.
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

/// Limits of which one is infinite. A blow-up from one side only, at an edge, is one infinite text; infinities of both signs are
/// two, and so are limits of which one is finite where the traction is infinite.
LimitText infinite_limits(const LimitText& limits, const LimitText& traction);
/// At a jump two numbers; at an end one, of the side in contact.
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
                                    has_unit ? stress_intensity_unit(*point.exponent) : ""});
  }
}

template <numeric::Real R>
SolutionText solution_text(const Problem& problem, const numeric::ContactSolution<R>& solution,
                           const SolutionWanted& wanted);

/// The limits as one number if they differ by no more than their errors, else as two: a blow-up from one side only, at
/// an edge, is one infinite text. Where `apart`, limits that agree look like one only to a person: files keep what
/// belongs to each side.
template <numeric::Real R>
LimitText limit_text(const numeric::TwoSided<R>& limits, const numeric::TwoSided<R>& traction, int digits,
                     bool apart = false);

}  // namespace steadyslide::app
