#pragma once
// A figure as a script for gnuplot 5.4, which prints an SVG of 800 units' width: 160 mm in print, 5 units a millimetre.

#include <string>

#include "app/figures/figure.hpp"

namespace steadyslide::app {

/// Numbers are written with so many digits: fewer than what two runs could differ in.
inline constexpr int figure_digits = 7;

/// "steadyslide figures --figure NAME"
std::string command_of(const Figure& figure);

/// The name with _ for -: what the SVG's ids begin with.
std::string id_prefix(const Figure& figure);

/// The whole script, data inline.
std::string gnuplot_script(const Figure& figure);

}  // namespace steadyslide::app
