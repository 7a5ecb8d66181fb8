#pragma once
// Warnings that a person should read before using a solution: large errors, gaps that no number resolves, and
// suspicious traces.

#include <string>
#include <vector>

#include "library/problem_file/problem_file.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::library {

/// The text of the warning of an estimated error.
inline constexpr const char* estimated_error_warning = "large estimated error";

/// Returns one line for each warning, "what; the rule; the value". There are warnings for: estimated errors above 10 %;
/// gaps over notches that are shown as contact, unless the notch is at rounding level, a jump of the slope of at most
/// 2^-49 sum_k k (|a_k| + |b_k|) |x|^(k-1), a_k and b_k the coefficients on both sides; contact that reaches the cut
/// end of a trace; contact of a trace that lies only within the last 1 % of the support.
template <numeric::Real R>
std::vector<std::string> warnings(const Problem& problem, const numeric::ContactSolution<R>& solution);

}  // namespace steadyslide::library
