#pragma once
// A solution as the texts that results show: the precision ends here, the writers see no numbers.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/problem_file/problem_file.hpp"
#include "app/results/exponent_text.hpp"
#include "model/uniqueness.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::app {

/// One text, or two where the limits from left and right differ. An empty text, here and below: no number, or not
/// known.
struct LimitText {
  std::string left;
  std::string right;

  bool two_sided() const { return left != right; }
};

struct SampleText {
  std::string x;
  LimitText traction;
  LimitText shear;
  std::optional<std::string> gap;  ///< absent outside the support
  LimitText slope;
};

struct EndText {
  std::string x;
  std::string kind;
  std::string exponent;
  std::string intensity;
};

struct SingularText {
  std::string x;
  std::string kind;
  ExponentText exponent;
  std::string intensity;
  std::string constant;
};

struct SolveReport {
  std::string method;
  int digits = 0;
  std::vector<std::pair<EndText, EndText>> contact;
  std::vector<SingularText> singular_points;
  std::string normal, tangential, centre_of_pressure, effective_friction;
  std::optional<std::string> tilt;  ///< absent unless the indenter may tilt
  std::vector<std::string> load_share;
  std::vector<SampleText> samples;
  std::string error_ends, error_traction, error_resultants;
  std::string residual_equation, residual_load, residual_penetration, residual_tension;
  Uniqueness uniqueness;
  std::string why_not;      ///< not empty: the method does not apply, and nothing else is here
  std::string shortcoming;  ///< not empty: the solve did not converge, in words
  bool in_range = true;     ///< false: some value is no number, or near the end of the range of its type

  bool is_solved() const { return why_not.empty() && shortcoming.empty(); }
};

/// What of a solution is told, and what makes it one.
struct ReportWanted {
  int digits = 16;
  std::vector<Rational> at{};  ///< samples at these places,
  int samples = 0;             ///< and so many a component and a gap
  /// A solution with a larger residual is none. Infinite for a method whose own shortcoming() weighs its residuals.
  double largest_residual = 1e-9;
};

template <numeric::Real R>
SolveReport make_report(const Problem& problem, const numeric::ContactSolution<R>& solution,
                        const ReportWanted& wanted);

/// The limits as one text or two: a blow-up from one side only, at an edge, is one infinite text.
template <numeric::Real R>
LimitText limit_text(const numeric::TwoSided<R>& limits, const numeric::TwoSided<R>& traction, int digits);

}  // namespace steadyslide::app
