#pragma once
// gnuplot 5.4: a figure as its script, and the program as a child process.

#include <string>

#include "app/figures/figure.hpp"

namespace steadyslide::app {

/// The whole script, data inline. It prints an SVG of 800 units' width: 160 mm in print, 5 units a millimetre.
std::string gnuplot_script(const Figure& figure);

/// What gnuplot draws from a script, without anybody's start-up files, in the C locale. Throws Failure (exit code 3)
/// where gnuplot is not found, cannot be run, or does not take the script.
std::string run_gnuplot(const std::string& script);

}  // namespace steadyslide::app
