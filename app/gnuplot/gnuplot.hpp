#pragma once
// gnuplot 5.4: a figure as its script, and the program as a child process.

#include <array>
#include <string>
#include <string_view>

#include "app/gnuplot/figure.hpp"

namespace steadyslide::app {

enum class Picture { svg, pdf, png };
/// "svg pdf png", as endings of names and as choices of an option.
inline constexpr std::array<std::string_view, 3> picture_names{"svg", "pdf", "png"};

/// The whole script, data inline. It prints a picture of 800 units' width: 160 mm in print, 5 units a millimetre; a PNG
/// has two pixels a unit.
std::string gnuplot_script(const Figure& figure, Picture picture = Picture::svg);

/// What gnuplot draws from a script, without anybody's start-up files, in the C locale. Throws Failure (exit code 3)
/// where gnuplot is not found, cannot be run, or does not take the script.
std::string run_gnuplot(const std::string& script);

/// The figure as the bytes of a picture. An SVG begins with the XML declaration, has the figure's title and description,
/// no scripts, and ids that begin with the figure's name. Throws Failure as run_gnuplot does.
std::string rendered_picture(const Figure& figure, Picture picture = Picture::svg);

}  // namespace steadyslide::app
