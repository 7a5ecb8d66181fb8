#pragma once
// The figures as SVG text.

#include <string>
#include <vector>

namespace steadyslide::app {

struct DrawnFigure {
  std::string name;
  std::string title;
  std::string caption;
  std::string command;  ///< draws it again
  std::string svg;
};

/// Those whose name matches one of the patterns; all of them if there is no pattern.
std::vector<DrawnFigure> draw_figures(const std::vector<std::string>& patterns);

}  // namespace steadyslide::app
