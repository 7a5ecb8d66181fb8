#include "app/figures/figure.hpp"

#include <limits>

namespace steadyslide::app {

const Point gap_in_curve{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

Panel empty_panel(const Frame& frame, const Axis& x, const Axis& y) {
  Panel panel;
  panel.frame = frame;
  panel.x = x;
  panel.y = y;
  return panel;
}

}  // namespace steadyslide::app
