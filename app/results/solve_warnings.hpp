#pragma once
// What a person should know before a solution is used: large errors, and traces that look wrong. One line each,
// "what; the rule; the value".

#include <string>
#include <vector>

#include "app/problem_file/problem_file.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::app {

/// Of estimated errors, relative as in numeric::EstimatedError. Above the first a warning, above the second no
/// solution.
inline constexpr double large_error = 0.1;
inline constexpr double useless_error_from = 0.5;

/// Estimated errors above 10 %; contact that reaches the cut end of a trace; contact of a trace within the last 1 % of
/// the support alone.
template <numeric::Real R>
std::vector<std::string> warnings(const Problem& problem, const numeric::ContactSolution<R>& solution);

/// Empty unless one of the errors is above 50 %, or no number.
template <numeric::Real R>
std::string useless_error(const numeric::EstimatedError<R>& error);

}  // namespace steadyslide::app
