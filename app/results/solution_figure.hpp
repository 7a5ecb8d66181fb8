#pragma once
// The picture of a solved problem: indenter, surface and contact zones above, pressure and tangential traction below, the
// singular points marked with their exponents.

#include "app/gnuplot/figure.hpp"
#include "app/results/solution_text.hpp"

namespace steadyslide::app {

/// Of a solution whose `curve` was asked for, lengths and stresses in the problem's own units. Tractions that go to
/// infinity are cut at six times the mean pressure, as the legend says.
Figure solution_figure(const Problem& problem, const SolutionText& solution);

}  // namespace steadyslide::app
