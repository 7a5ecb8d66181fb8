#pragma once
// Pressure under a flat punch with two coatings, the smoother one on the left, sliding one way or the other.
// [Bal16, (5)-(7) and figure 4]

#include "app/figures/figure.hpp"
#include "model/direction.hpp"

namespace steadyslide::app {

Figure two_coatings_figure(std::string name, std::string title, const std::string& what_it_shows, Sliding sliding);

}  // namespace steadyslide::app
