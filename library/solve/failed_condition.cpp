#include "library/solve/failed_condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>

#include "library/solve/method.hpp"
#include "library/text/number_format.hpp"

namespace steadyslide::library {

template <numeric::Real R>
std::vector<NamedError> named(const numeric::EstimatedError<R>& error) {
  return {{"ends of contact", "the contact's length", static_cast<double>(error.ends)},
          {"traction", "its size", static_cast<double>(error.traction)},
          {"resultants", "the load", static_cast<double>(error.resultants)}};
}

template <numeric::Real R>
std::vector<std::pair<std::string, R>> named(const numeric::Residuals<R>& residuals) {
  return {{"equation", residuals.equation},
          {"load", residuals.load},
          {"penetration", residuals.penetration},
          {"tension", residuals.tension}};
}

std::string percent(double part) { return std::isfinite(part) ? fmt::format("{:.3g} %", 100 * part) : "unknown"; }

template <numeric::Real R>
std::string useless_error(const numeric::EstimatedError<R>& error) {
  for (const NamedError& part : named(error)) {
    const bool useful = part.value <= useless_error_from;
    if (!useful)
      return fmt::format("the estimated error of the {} is {} of {}", part.name, percent(part.value), part.of);
  }
  return "";
}

template <numeric::Real R>
double largest_residual_of(const ContactProblem& problem, const numeric::ContactSolution<R>& solution) {
  constexpr double largest_in_double = 1e-6;
  if (may_take_more_digits(problem) || !std::same_as<R, double>) return largest_residual;
  const auto error = static_cast<double>(solution.estimated_error().traction);
  return error > largest_residual ? std::min(error, largest_in_double) : largest_residual;
}

template <numeric::Real R>
std::string failed_condition(const numeric::ContactSolution<R>& solution, const numeric::Residuals<R>& residuals,
                             double most_residual, bool converged) {
  if (std::string text = solution.failed_condition(); !text.empty()) return text;
  for (const auto& [name, value] : named(residuals)) {
    const bool small = value <= most_residual;  // false for NaN
    if (!small) return fmt::format("{} has the residual {}", name, size_text(value, 2));
  }
  if (!converged) return "a value stalled before its tolerance";
  return useless_error(solution.estimated_error());
}

#define STEADYSLIDE_FAILED_CONDITION(R)                                                           \
  template double largest_residual_of(const ContactProblem&, const numeric::ContactSolution<R>&); \
  template std::vector<NamedError> named(const numeric::EstimatedError<R>&);                      \
  template std::vector<std::pair<std::string, R>> named(const numeric::Residuals<R>&);            \
  template std::string useless_error(const numeric::EstimatedError<R>&);                          \
  template std::string failed_condition(const numeric::ContactSolution<R>&, const numeric::Residuals<R>&, double, bool)
STEADYSLIDE_FAILED_CONDITION(double);
STEADYSLIDE_FAILED_CONDITION(numeric::Real50);
STEADYSLIDE_FAILED_CONDITION(numeric::Real100);

}  // namespace steadyslide::library
