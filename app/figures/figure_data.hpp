#pragma once
// A figure's numbers as CSV: comments that say what the curves are and in which units, then
//
//   panel,curve,x,y,value
//
// one row for each point of each curve, in all digits of a double; `value` is that of a map, which is curve 0.

#include <string>

#include "app/gnuplot/figure.hpp"

namespace steadyslide::app {

std::string figure_data(const Figure& figure);

/// Returns enhanced text as plain text: "{/:Italic t}_n" becomes "t_n".
std::string plain_text(const std::string& enhanced);

}  // namespace steadyslide::app
