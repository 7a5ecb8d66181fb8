#pragma once
// The figures of the theory: computed from data when they are needed, drawn by gnuplot.

#include <string>
#include <vector>

#include "app/gnuplot/figure.hpp"
#include "app/gnuplot/gnuplot.hpp"

namespace steadyslide::app {

struct FigureMaker {
  std::string name;
  Figure (*make)();
};

/// All figures, those of the paper first. `local-forms` is the function make_local_forms() in drawings/local_forms.cpp.
const std::vector<FigureMaker>& figures();

struct DrawnFigure {
  std::string name;
  std::string title;
  std::string caption;  ///< formulas between backticks, in the notation of claims
  std::string command;  ///< the command that makes it
  std::string picture;  ///< an SVG begins with the XML declaration; no scripts; ids begin with the name
  std::string data{};   ///< figure_data()
};

/// Throws Failure if gnuplot is missing or fails.
DrawnFigure draw(const Figure& figure, Picture picture = Picture::svg);

/// Draws the figures whose name matches one of the patterns with the wildcards * and ?, or all figures without a
/// pattern; `jobs` at a time. Shows progress on stderr, if that is a terminal. Throws Failure: exit code 2 for a
/// pattern that matches no figure, 3 if gnuplot is missing or fails. Throws std::runtime_error if a problem is not
/// solved.
std::vector<DrawnFigure> draw_figures(const std::vector<std::string>& patterns, unsigned jobs,
                                      Picture picture = Picture::svg);

}  // namespace steadyslide::app
