#pragma once
// A figure's numbers as CSV: comments with the names and units of the curves, then
//
//   panel,curve,x,y,value
//
// one row for each point of each curve, with all digits of a double. Only a map, which is curve 0, has a `value`.

#include <string>

#include "app/gnuplot/figure.hpp"

namespace steadyslide::app {

std::string figure_data(const Figure& figure);

/// Returns enhanced text as plain text: "{/:Italic t}_n" becomes "t_n".
std::string plain_text(const std::string& enhanced);

}  // namespace steadyslide::app
