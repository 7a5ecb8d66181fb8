#pragma once
// A formula in the ASCII notation of docs/notation.md, read.
//
//   row     = { operand | sign | a "/" b }
//   operand = (number | name | "(" row ")" | "[" row "[" | "|" row "|" | "<<" row ">>" | "sqrt" operand) scripts
//   scripts = { "_" script | "^" script | "'" }
//   script  = "{" row "}" | [sign] (number | name | "(" row ")") | sign
//
// A fraction is stacked where nothing around it is small already, and has all the factors before the solidus above the
// bar: a b/c is the same number either way.

#include <optional>
#include <string_view>

#include "app/report/math_row.hpp"

namespace steadyslide::app {

/// Nothing for a text that is no formula.
std::optional<MathRow> parse_math(std::string_view formula);

}  // namespace steadyslide::app
