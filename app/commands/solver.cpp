#include "app/commands/solver.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/results/certified_text.hpp"
#include "numeric/variational/variational_solution.hpp"

namespace steadyslide::app {
namespace {

SolutionText inapplicable(const std::string& reason) {
  SolutionText text;
  text.reason = reason;
  return text;
}

}  // namespace

SolutionText Solver::solve_on_cells(const Problem& problem) const {
  numeric::VariationalOptions options = wanted_.variational;
  if (!wanted_.cells_chosen && !wanted_.certify) options.accuracy = default_accuracy(problem);
  const auto found = numeric::variational_inequality(problem.contact, options);
  if (!found.solution) return inapplicable(found.reason);
  SolutionWanted wanted = wanted_.solution;
  // A solution on cells judges its residuals itself.
  wanted.largest_residual = numeric::infinity<double>();
  SolutionText text = solution_text(problem, *found.solution, wanted);
  const auto [ends, traction, resultants] = found.solution->estimated_error();
  const double accuracy = options.accuracy, error = std::max(ends, resultants);
  if (accuracy > 0 && error > accuracy && text.is_solved()) {
    text.warnings.push_back(
        fmt::format("accuracy not reached; cells are refined until ends and resultants have the "
                    "relative error {:.2g}; {:.2g}",
                    accuracy, error));
  }
  if (text.is_solved() && !text.in_range) text.failed_condition = "values out of the range of double";
  if (wanted_.certify) {
    const auto& on_cells = dynamic_cast<const numeric::VariationalSolution&>(*found.solution);
    add_bound(text, problem, enclosure::bound_cells(problem.contact, on_cells.touching_pressures()));
  }
  return text;
}

template <numeric::Real R>
SolutionText Solver::solve_in(const Problem& problem) {
  auto& last = std::get<Solution<R>>(last_);
  const numeric::Attempt<R> found = attempt<R>(wanted_.method, problem.contact, last.get());
  if (!found.solution) return inapplicable(found.reason);
  SolutionText text = solution_text(problem, *found.solution, wanted_.solution);
  if (text.is_solved()) last = found.solution;
  return text;
}

std::vector<StretchText> Solver::certify_load_range(const Problem& problem, const Rational& from, const Rational& to) {
  const auto contact_at = [&](const Rational& load) -> std::optional<ApproximateContact> {
    const numeric::Attempt<double> found = attempt<double>(wanted_.method, problem.contact.with_load(load), nullptr);
    if (!found.solution || !found.solution->failed_condition().empty()) return std::nullopt;
    return found.solution->approximate_contact();
  };
  std::vector<StretchText> result;
  enclosure::LoadPathOptions options;
  options.intervals_alone = wanted_.certificate;
  options.threads = wanted_.jobs;
  for (const enclosure::LoadStretch& stretch :
       enclosure::follow_loads(problem.contact, from, to, contact_at, options)) {
    StretchText text = stretch_text(stretch, wanted_.solution.digits);
    if (stretch.interval) intervals_.push_back(*stretch.interval);
    // Two proved stretches in a row are one branch.
    if (!result.empty() && text.is_proved() && result.back().is_proved()) {
      result.back().to = text.to;
    } else {
      result.push_back(std::move(text));
    }
  }
  return result;
}

template <numeric::Real R>
std::optional<library::FoundContact> Solver::contact_in(const Problem& problem, std::function<SolutionText()>& text) {
  auto& last = std::get<Solution<R>>(last_);
  const numeric::Attempt<R> found = attempt<R>(wanted_.method, problem.contact, last.get());
  if (!found.solution) {
    text = [reason = found.reason] { return inapplicable(reason); };
    return std::nullopt;
  }
  SolutionWanted approximate = wanted_.solution;
  approximate.digits = std::min(approximate.digits, 16);
  text = [&last, &problem, approximate, solution = found.solution] {
    SolutionText result = solution_text(problem, *solution, approximate);
    if (result.is_solved()) last = solution;
    return result;
  };
  return library::FoundContact{found.solution->approximate_contact(), found.solution->failed_condition().empty()};
}

SolutionText Solver::solve_certified(const Problem& problem) {
  // Only the last solution needs a text. With more than 16 digits, a text costs as much as a solution.
  std::function<SolutionText()> text_of_last;
  const auto found = [&](int digits) {
    return numeric::at_precision(numeric::precision_for(digits),
                                 [&]<numeric::Real R>() { return contact_in<R>(problem, text_of_last); });
  };
  const int first = fits_double(problem.contact, wanted_.solution.at) ? 16 : 50;
  const auto proof = library::proved_contact(problem.contact, wanted_.solution.digits, first, found);
  SolutionText text = text_of_last();
  if (proof && text.reason.empty()) certify(text, problem, *proof, wanted_.solution, wanted_.jobs);
  return text;
}

SolutionText Solver::solve(const Problem& problem) {
  if (takes_variational(wanted_.method, problem.contact, wanted_.certify, wanted_.solution.digits))
    return solve_on_cells(problem);
  if (wanted_.certify) return solve_certified(problem);
  SolutionText text = in_precision(
      wanted_.solution.digits, problem.contact, wanted_.solution.at,
      [&]<numeric::Real R>() { return solve_in<R>(problem); },
      [](const SolutionText& found) { return !found.reason.empty() || (found.is_solved() && found.in_range); });
  if (text.is_solved() || !may_fall_back(wanted_.method, wanted_.solution.digits)) return text;
  SolutionText on_cells = solve_on_cells(problem);
  if (!on_cells.is_solved()) return text;
  on_cells.instead = fallen_back(text.reason + text.failed_condition);
  on_cells.warnings.insert(on_cells.warnings.begin(), on_cells.instead);
  return on_cells;
}

}  // namespace steadyslide::app
