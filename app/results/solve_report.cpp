#include "app/results/solve_report.hpp"

#include <fmt/format.h>

#include "app/results/number_format.hpp"
#include "app/results/solve_warnings.hpp"

namespace steadyslide::app {
namespace {

using numeric::Estimate;
using numeric::Real;
using numeric::TwoSided;

template <Real R>
bool is_infinite(const R& value) {
  using std::abs;
  return abs(value) == numeric::infinity<R>();
}

/// Texts of numbers, and what was noticed on the way.
template <Real R>
class Writer {
 public:
  Writer(SolveReport& report, int digits) : report_(report), digits_(digits) {}

  NumberText text(const Estimate<R>& estimate) {
    notice(estimate);
    return number_text(estimate, digits_);
  }

  std::string size(const R& value) {
    notice(value);
    return size_text(value, digits_);
  }

  LimitText limits(const TwoSided<R>& values, const TwoSided<R>& traction, bool apart = false) {
    notice(values.left);
    notice(values.right);
    return limit_text(values, traction, digits_, apart);
  }

  bool converged() const { return converged_; }

 private:
  void notice(const Estimate<R>& estimate) {
    if (estimate.convergence == numeric::Convergence::stalled) converged_ = false;
    if (is_infinite(estimate.error)) return;  // not known, and printed as such
    notice(estimate.value);
  }

  void notice(const R& value) {
    using std::abs, std::isnan;
    const R magnitude = abs(value);
    if (magnitude == 0 || is_infinite(magnitude)) return;
    // Also false for what is no number.
    const bool fine = magnitude < R(1e150) && magnitude > R(1e-150);
    if (!fine) report_.in_range = false;
    if (isnan(value)) converged_ = false;
  }

  SolveReport& report_;
  int digits_;
  bool converged_ = true;
};

/// What stands in the way of calling it a solution.
template <Real R>
std::string shortcoming(const numeric::ContactSolution<R>& solution, const numeric::Residuals<R>& residuals,
                        double largest_residual, bool converged) {
  if (std::string text = solution.shortcoming(); !text.empty()) return text;
  for (const auto& [name, value] : {std::pair("equation", residuals.equation),
                                    {"load", residuals.load},
                                    {"penetration", residuals.penetration},
                                    {"tension", residuals.tension}}) {
    const bool small = value <= largest_residual;  // no number is not
    if (!small) return fmt::format("{} has the residual {}", name, size_text(value, 2));
  }
  if (!converged) return "a value stalled before its tolerance";
  return useless_error(solution.estimated_error());
}

template <Real R>
EndText end_text(const numeric::ContactEnd<R>& end, int digits, Writer<R>& writer) {
  return {writer.text(end.x), std::string(name_of(end.kind)), format_exponent(end.exponent, digits),
          writer.text(end.intensity)};
}

template <Real R>
SampleText sample_text(const numeric::Sample<R>& sample, std::string x, Writer<R>& writer) {
  SampleText text;
  text.x = std::move(x);
  // Both or neither: |shear| = f |traction| holds on either side, not between the sides.
  const bool apart = !agree(sample.traction) || !agree(sample.shear);
  text.traction = writer.limits(sample.traction, sample.traction, apart);
  text.shear = writer.limits(sample.shear, sample.traction, apart);
  if (sample.gap) text.gap = writer.text(*sample.gap);
  text.slope = writer.limits(sample.slope, sample.slope);
  return text;
}

}  // namespace

template <Real R>
bool agree(const TwoSided<R>& limits) {
  using std::abs;
  const R errors = limits.left.error + limits.right.error;
  // A part of the last digit more: the errors of f t are those of t, each times f and rounded.
  return abs(limits.left.value - limits.right.value) <= errors * (1 + 4 * numeric::epsilon<R>());
}

template <Real R>
LimitText limit_text(const TwoSided<R>& limits, const TwoSided<R>& traction, int digits, bool apart) {
  const Estimate<R>& left = limits.left;
  const Estimate<R>& right = limits.right;
  LimitText text{number_text(left, digits), number_text(right, digits)};
  if (is_infinite(left.value) || is_infinite(right.value)) {
    const LimitText infinite =
        is_infinite(left.value) ? LimitText{text.left, text.left} : LimitText{text.right, text.right};
    const bool opposite = is_infinite(left.value) && is_infinite(right.value) && left.value != right.value;
    // Without friction the shear stays 0 where the traction blows up: that limit is worth telling.
    const bool blows_up_alone = (is_infinite(traction.left.value) && !is_infinite(left.value)) ||
                                (is_infinite(traction.right.value) && !is_infinite(right.value));
    return opposite || blows_up_alone ? text : infinite;
  }
  const bool known = !text.left.shown.empty() && !text.right.shown.empty();
  if (!known || !agree(limits)) return text;
  if (apart) {
    text.right.shown = text.left.shown;
  } else {
    text.right = text.left;
  }
  return text;
}

template <Real R>
SolveReport make_report(const Problem& problem, const numeric::ContactSolution<R>& solution,
                        const ReportWanted& wanted) {
  const int digits = wanted.digits;
  SolveReport report;
  Writer<R> writer(report, digits);
  report.method = solution.method();
  report.digits = digits;
  for (const auto& component : solution.contact()) {
    report.contact.emplace_back(end_text(component.left, digits, writer), end_text(component.right, digits, writer));
  }
  for (const auto& point : solution.singular_points()) {
    report.singular_points.push_back({writer.text(point.x), std::string(name_of(point.kind)),
                                      exponent_text(point.exponent, digits), writer.text(point.intensity),
                                      writer.text(point.constant)});
  }
  const numeric::Resultants<R> resultants = solution.resultants();
  report.normal = writer.text(resultants.normal);
  report.tangential = writer.text(resultants.tangential);
  report.centre_of_pressure = writer.text(resultants.centre_of_pressure);
  report.effective_friction = writer.text(resultants.effective_friction);
  for (const Estimate<R>& share : resultants.load_share) report.load_share.push_back(writer.text(share));
  if (const auto tilt = solution.tilt()) report.tilt = writer.text(*tilt);

  for (const Rational& x : wanted.at) {
    report.samples.push_back(sample_text(solution.at(x), full_number(x, digits), writer));
  }
  if (wanted.samples > 0) {
    for (const numeric::Sample<R>& sample : solution.samples(wanted.samples)) {
      report.samples.push_back(sample_text(sample, full_number(sample.x, digits), writer));
    }
  }

  const numeric::EstimatedError<R> error = solution.estimated_error();
  report.error_ends = writer.size(error.ends);
  report.error_traction = writer.size(error.traction);
  report.error_resultants = writer.size(error.resultants);
  const numeric::Residuals<R> residuals = solution.residuals();
  report.warnings = warnings(problem, solution);
  report.shortcoming = shortcoming(solution, residuals, wanted.largest_residual, writer.converged());
  report.residual_equation = writer.size(residuals.equation);
  report.residual_load = writer.size(residuals.load);
  report.residual_penetration = writer.size(residuals.penetration);
  report.residual_tension = writer.size(residuals.tension);
  report.uniqueness = uniqueness(problem.contact);
  return report;
}

#define STEADYSLIDE_REPORT_AT(R)                                                                             \
  template SolveReport make_report(const Problem&, const numeric::ContactSolution<R>&, const ReportWanted&); \
  template bool agree(const TwoSided<R>&);                                                                   \
  template LimitText limit_text(const TwoSided<R>&, const TwoSided<R>&, int, bool)
STEADYSLIDE_REPORT_AT(double);
STEADYSLIDE_REPORT_AT(numeric::Real50);
STEADYSLIDE_REPORT_AT(numeric::Real100);

}  // namespace steadyslide::app
