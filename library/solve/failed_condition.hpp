#pragma once
// What stands in the way of calling the best state that a method has reached a solution.

#include <string>
#include <utility>
#include <vector>

#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::library {

/// A solution with a larger residual is none; of a method on cells, failed_condition() weighs its residuals itself.
inline constexpr double largest_residual = 1e-9;

/// Of estimated errors, relative as in numeric::EstimatedError. Above the first a warning, above the second no
/// solution.
inline constexpr double large_error = 0.1;
inline constexpr double useless_error_from = 0.5;

struct NamedError {
  std::string name;
  std::string of;
  double value;
};
template <numeric::Real R>
std::vector<NamedError> named(const numeric::EstimatedError<R>& error);
template <numeric::Real R>
std::vector<std::pair<std::string, R>> named(const numeric::Residuals<R>& residuals);

/// "12 %", "unknown" if it is not finite.
std::string percent(double part);

/// Empty unless one of the errors is above 50 %, or no number.
template <numeric::Real R>
std::string useless_error(const numeric::EstimatedError<R>& error);

/// In words; empty for a solution. `converged`: has every value that was asked for?
template <numeric::Real R>
std::string failed_condition(const numeric::ContactSolution<R>& solution, const numeric::Residuals<R>& residuals,
                             double most_residual = largest_residual, bool converged = true);

}  // namespace steadyslide::library
