#pragma once
// The figures of the theory: computed from data on the spot, drawn by gnuplot.

#include <string>
#include <vector>

#include "app/gnuplot/figure.hpp"
#include "app/gnuplot/gnuplot.hpp"

namespace steadyslide::app {

struct FigureMaker {
  std::string name;
  Figure (*make)();
};

/// All of them, the paper's first: `local-forms` is the function make_local_forms() in drawings/local_forms.cpp.
const std::vector<FigureMaker>& figures();

struct DrawnFigure {
  std::string name;
  std::string title;
  std::string caption;  ///< formulas between backticks, in the notation of claims
  std::string command;  ///< that makes it
  std::string picture;  ///< an SVG begins with the XML declaration; no scripts; ids begin with the name
  std::string data{};   ///< figure_data()
};

/// Throws Failure where gnuplot is missing or fails.
DrawnFigure draw(const Figure& figure, Picture picture = Picture::svg);

/// Those whose name matches one of the patterns, * and ? being wildcards; all without patterns. Draws `jobs` of them at a
/// time. Progress on stderr, where that is a terminal. Throws Failure: exit code 2 for a pattern that names no figure, 3
/// where gnuplot is missing or fails; std::runtime_error if a problem is not solved.
std::vector<DrawnFigure> draw_figures(const std::vector<std::string>& patterns, unsigned jobs,
                                      Picture picture = Picture::svg);

}  // namespace steadyslide::app
