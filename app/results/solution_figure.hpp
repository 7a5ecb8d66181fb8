#pragma once
// The picture of a solved problem. Above: indenter, surface and contact zones. Below: pressure and tangential traction.
// The singular points are marked with their exponents.

#include "app/gnuplot/figure.hpp"
#include "app/results/solve_writers.hpp"

namespace steadyslide::app {

/// Draws a solution that has its `curve`, with lengths and stresses in the problem's own units. Infinite tractions are
/// cut at six times the mean pressure; the legend says so.
Figure solution_figure(const Problem& problem, const SolutionText& solution);
/// The same for both directions of sliding: the contact zones of both, and the tractions below each other. `turned` is
/// the problem with the opposite direction.
Figure solution_figure(const Problem& problem, const Problem& turned, const BothText& both);

}  // namespace steadyslide::app
