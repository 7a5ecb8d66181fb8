#pragma once
// The reason why the best state that a method has reached is not a solution.

#include <string>
#include <utility>
#include <vector>

#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::library {

/// A state with a larger residual is not a solution. Methods on cells judge their residuals in their own
/// failed_condition().
inline constexpr double largest_residual = 1e-9;

/// The same for a profile of so many pieces that it is solved in double alone. There the rounding of its polynomials
/// may leave a larger residual: up to the estimated error of the traction, at most 1e-6.
template <numeric::Real R>
double largest_residual_of(const ContactProblem& problem, const numeric::ContactSolution<R>& solution);

/// Limits of estimated errors, relative as in numeric::EstimatedError. Above the first one there is a warning; above
/// the second one the state is not a solution.
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

/// Returns "12 %", or "unknown" if the number is not finite.
std::string percent(double part);

/// The reason if one of the errors is above 50 % or NaN; otherwise empty.
template <numeric::Real R>
std::string useless_error(const numeric::EstimatedError<R>& error);

/// Returns the reason in words; empty for a solution. `converged`: every requested value reached its tolerance.
template <numeric::Real R>
std::string failed_condition(const numeric::ContactSolution<R>& solution, const numeric::Residuals<R>& residuals,
                             double most_residual = largest_residual, bool converged = true);

}  // namespace steadyslide::library
