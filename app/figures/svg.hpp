#pragma once
// What gnuplot's SVG lacks for a page that holds several.

#include <string>

#include "app/figures/figure.hpp"

namespace steadyslide::app {

/// Ids and references to them begin with the figure's name, title and description are the figure's, and fonts have
/// others to fall back on.
std::string finished_svg(const std::string& svg, const Figure& figure);

}  // namespace steadyslide::app
