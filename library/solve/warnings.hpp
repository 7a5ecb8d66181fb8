#pragma once
// What a person should know before a solution is used: large errors, gaps that no number resolves, and traces that look
// wrong.

#include <string>
#include <vector>

#include "library/problem_file/problem_file.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::library {

/// What a warning of an estimated error says.
inline constexpr const char* estimated_error_warning = "large estimated error";

/// Estimated errors above 10 %; gaps over notches that are shown as contact, unless the notch is no more than rounding: a
/// jump of the slope of at most 2^-49 sum_k k (|a_k| + |b_k|) |x|^(k-1), a_k and b_k the coefficients on both sides; contact
/// that reaches the cut end of a trace;
/// contact of a trace within the last 1 % of the support alone. One line each, "what; the rule; the value".
template <numeric::Real R>
std::vector<std::string> warnings(const Problem& problem, const numeric::ContactSolution<R>& solution);

}  // namespace steadyslide::library
