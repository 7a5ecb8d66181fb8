#pragma once
// Friction coefficients as a table x,f (table_reader.hpp): f holds from its x to the next one, and the last f to the
// right end of the support. x increases strictly. All numbers are exact; every error message names the file and the
// line.

#include <string>
#include <string_view>

#include "library/problem_file/profile_trace.hpp"
#include "model/friction_profile.hpp"

namespace steadyslide::library {

inline constexpr std::size_t max_friction_values = 90000;

/// Takes `unit`, the unit of x in the table as a multiple of the problem's unit. Rows that hold nowhere inside the
/// support are left out. Throws InvalidFile, also if the first row is to the right of the support's left end.
FrictionProfile parse_friction_table(std::string_view text, const std::string& name, const Support& support,
                                     const Rational& unit);

}  // namespace steadyslide::library
