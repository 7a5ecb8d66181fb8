#pragma once
// gnuplot 5.4: writes a figure as a script, and runs gnuplot as a child process.

#include <array>
#include <string>
#include <string_view>

#include "app/gnuplot/figure.hpp"

namespace steadyslide::app {

enum class Picture { svg, pdf, png };
/// "svg pdf png": the endings of file names and the choices of an option.
inline constexpr std::array<std::string_view, 3> picture_names{"svg", "pdf", "png"};

/// Returns the whole script with its data. The picture is 800 units wide: 160 mm in print, 5 units a millimetre; a PNG
/// has two pixels a unit.
std::string gnuplot_script(const Figure& figure, Picture picture = Picture::svg);

/// Returns what gnuplot draws from a script. gnuplot runs without start-up files, in the C locale. Throws Failure (exit
/// code 3) if gnuplot is not found, cannot be run, or does not accept the script.
std::string run_gnuplot(const std::string& script);

/// Returns the figure as the bytes of a picture. An SVG begins with the XML declaration. It has the figure's title and
/// description, no scripts, and ids that begin with the figure's name. Throws Failure like run_gnuplot.
std::string rendered_picture(const Figure& figure, Picture picture = Picture::svg);

}  // namespace steadyslide::app
