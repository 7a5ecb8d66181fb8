#pragma once
// Fractions in a row.

#include "app/report/math_row.hpp"

namespace steadyslide::app {

/// Divides the last factors of the row, of which there is one at least: one above the other where the row is not small
/// and the parts are short, with a solidus otherwise.
void divide(MathRow& row, MathRow denominator, bool small);

/// (1/pi) x as 1/pi x, where the last element is a bracket around nothing but a stacked fraction.
void drop_idle_brackets(MathRow& row);

}  // namespace steadyslide::app
