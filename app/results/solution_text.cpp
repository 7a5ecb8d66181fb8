#include "app/results/solution_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "library/answer/solved_contact.hpp"
#include "library/solve/double_range.hpp"
#include "library/solve/warnings.hpp"
#include "model/uniqueness.hpp"

namespace steadyslide::app {
namespace {

using numeric::Estimate;
using numeric::Real;
using numeric::TwoSided;
using std::isinf, std::isnan;

/// True if the limits differ by no more than their errors.
template <Real R>
bool agree(const TwoSided<R>& limits) {
  using std::abs;
  const R errors = limits.left.error + limits.right.error;
  // Allows for the rounding of the errors: the errors of f t are those of t times f, each rounded.
  return abs(limits.left.value - limits.right.value) <= errors * (1 + 4 * numeric::epsilon<R>());
}

/// Makes texts of numbers, and notes numbers out of range.
template <Real R>
class Writer {
 public:
  Writer(SolutionText& result, const SolutionWanted& wanted)
      : result_(result), wanted_(wanted.entries), digits_(wanted.digits) {}

  /// Announces the numbers of this entry. They become texts only if the entry is wanted; their range is checked in any
  /// case.
  void tell(const char* entry) { told_ = wanted_.empty() || std::ranges::find(wanted_, entry) != wanted_.end(); }

  bool told() const { return told_; }
  int digits() const { return digits_; }

  NumberText number(const Estimate<R>& estimate) {
    notice(estimate);
    return told_ ? number_text(estimate, digits_) : NumberText{};
  }

  /// The coefficient of the singular traction at a place.
  NumberText intensity(const Estimate<R>& estimate) {
    notice(estimate, library::has_double<R>);
    return told_ ? number_text(estimate, digits_) : NumberText{};
  }

  std::vector<NamedSize> sizes(const std::vector<std::pair<std::string, R>>& values) {
    std::vector<NamedSize> result;
    for (const auto& [name, value] : values) {
      notice(Estimate<R>{value});
      if (told_) result.push_back({name, size_text(value, digits_)});
    }
    return result;
  }

  /// A sample that does not converge carries its error; the solution is still valid.
  SampleText sample(std::string x, const numeric::DetailedSample<R>& sample, const ContactProblem& problem) {
    const auto friction = [&](std::size_t piece) { return exact_text(problem.friction().values()[piece]); };
    // Both have two limits or neither: |shear| = f |traction| holds on one side, not across the sides.
    const bool apart = !agree(sample.traction) || !agree(sample.shear);
    return {std::move(x),
            limits(sample.traction, sample.traction, apart),
            limits(sample.shear, sample.traction, apart),
            sample.gap ? number(*sample.gap) : NumberText{},
            limits(sample.slope, sample.slope, false),
            number_text(sample.displacement, digits_),
            limit_text(sample.shear_slope, sample.shear_slope, digits_),
            number_text(sample.cumulative_load, digits_),
            sample.friction ? std::pair(friction(sample.friction->left), friction(sample.friction->right))
                            : std::pair<std::string, std::string>()};
  }

  /// Converts the quantities of the table (library/answer/quantities.hpp).
  NumberText operator()(const Estimate<R>& estimate) { return number(estimate); }
  ResultantsText::Largest operator()(const numeric::LargestPressure<R>& largest) {
    const bool infinite = isinf(largest.value.value);
    return {number(largest.value), number(largest.x),
            infinite && told_ ? exponent_text(largest.exponent, digits_).value : ""};
  }

  void add_samples(std::vector<SampleText>& texts, const numeric::ContactSolution<R>& solution, int count,
                   const ContactProblem& problem) {
    for (const numeric::DetailedSample<R>& one : solution.detailed_samples(count))
      texts.push_back(sample(full_number(one.x, digits_), one, problem));
  }

  bool converged() const { return converged_; }

 private:
  LimitText limits(const TwoSided<R>& values, const TwoSided<R>& traction, bool apart) {
    notice(values.left);
    notice(values.right);
    return limit_text(values, traction, digits_, apart);
  }

  void notice(const Estimate<R>& estimate, bool (*fits)(const R&) = library::squares_in_double<R>) {
    if (estimate.convergence == numeric::Convergence::stalled) converged_ = false;
    if (!library::is_in_range(estimate, fits)) result_.in_range = false;
    if (isnan(estimate.value) && !isinf(estimate.error)) converged_ = false;
  }

  SolutionText& result_;
  const std::vector<std::string>& wanted_;
  int digits_;
  bool told_ = true;
  bool converged_ = true;
};

/// The number of places of a picture in each component and gap.
int curve_samples(std::size_t components) {
  return static_cast<int>(std::max<std::size_t>(3200 / std::max<std::size_t>(components, 8), 24));
}

}  // namespace

LimitText infinite_limits(const LimitText& limits, const LimitText& traction) {
  const auto is_infinite = [](const NumberText& number) { return number.value.ends_with("inf"); };
  const auto& [left, right, apart] = limits;
  const bool opposite = is_infinite(left) && is_infinite(right) && left.value != right.value;
  // The shear stays 0 without friction, even where the traction is infinite. Both limits are then printed.
  const bool blows_up_alone =
      (is_infinite(traction.left) && !is_infinite(left)) || (is_infinite(traction.right) && !is_infinite(right));
  if (opposite || blows_up_alone) return limits;
  const NumberText& infinite = is_infinite(left) ? left : right;
  return {infinite, infinite};
}

LimitText stress_intensity_text(SingularKind kind, const NumberText& left, const NumberText& right) {
  // At a friction jump the stress intensities on the two sides differ.
  if (local_terms(kind).friction_jumps) return {left, right, true};
  const NumberText& one = left.value.empty() ? right : left;
  return {one, one};
}

template <Real R>
LimitText limit_text(const TwoSided<R>& limits, const TwoSided<R>& traction, int digits, bool apart) {
  const Estimate<R>& left = limits.left;
  const Estimate<R>& right = limits.right;
  LimitText text{number_text(left, digits), number_text(right, digits)};
  if (isinf(left.value) || isinf(right.value)) {
    return infinite_limits(text, {number_text(traction.left, digits), number_text(traction.right, digits)});
  }
  const bool known = !text.left.shown.empty() && !text.right.shown.empty();
  if (!known || !agree(limits)) return text;
  if (!apart) return {text.left, text.left};
  text.right.shown = text.left.shown;
  return text;
}

template <Real R>
SolutionText solution_text(const Problem& problem, const numeric::ContactSolution<R>& solution,
                           const SolutionWanted& wanted) {
  SolutionText text;
  Writer<R> writer(text, wanted);
  text.method = solution.method();
  text.digits = wanted.digits;
  if (const auto cells = solution.equal_cells()) {
    const auto end = [&](const Rational& x) {
      return NumberText{format_number(x, 6), full_number(x, wanted.digits), "0"};
    };
    text.cells = {cells->count, end(cells->left), end(cells->right)};
  }
  const SolvedContact<R> solved(problem.contact, solution, wanted.over);
  writer.tell("contact");
  set_contact(text, solved.contact(), writer);
  text.component_load = answer::converted(writer, solved.forces().component_load);
  writer.tell("singular_points");
  set_singular_points(text, solution.singular_points(), writer);
  writer.tell("resultants");
  text.resultants = answer::resultants_of<ResultantsText>(solved, writer);

  writer.tell("samples");
  for (const Rational& x : wanted.at)
    text.samples.push_back(writer.sample(full_number(x, wanted.digits), solution.details_at(x), problem.contact));
  if (wanted.samples > 0) writer.add_samples(text.samples, solution, wanted.samples, problem.contact);
  if (wanted.curve) writer.add_samples(text.curve, solution, curve_samples(text.contact.size()), problem.contact);

  text.field = field_text(problem.contact, solution, wanted.field, wanted.over, wanted.digits);
  if (!text.field.in_range) text.in_range = false;
  const numeric::EstimatedError<R> error = solution.estimated_error();
  writer.tell("estimated_error");
  text.errors = writer.sizes({{"ends", error.ends}, {"traction", error.traction}, {"resultants", error.resultants}});
  text.warnings = warnings(problem, solution);
  const numeric::Residuals<R> residuals = solution.residuals();
  const double most = wanted.largest_residual.value_or(library::largest_residual_of(problem.contact, solution));
  text.failed_condition = library::failed_condition(solution, residuals, most, writer.converged());
  writer.tell("residuals");
  text.residuals = writer.sizes(named(residuals));
  text.uniqueness = uniqueness_theorem(problem.contact);
  return text;
}

#define STEADYSLIDE_SOLUTIONS_AS_TEXT(R)                                                                          \
  template SolutionText solution_text(const Problem&, const numeric::ContactSolution<R>&, const SolutionWanted&); \
  template LimitText limit_text(const TwoSided<R>&, const TwoSided<R>&, int, bool)
STEADYSLIDE_SOLUTIONS_AS_TEXT(double);
STEADYSLIDE_SOLUTIONS_AS_TEXT(numeric::Real50);
STEADYSLIDE_SOLUTIONS_AS_TEXT(numeric::Real100);

}  // namespace steadyslide::app
