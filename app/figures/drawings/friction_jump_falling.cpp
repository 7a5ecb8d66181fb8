#include "app/figures/two_coatings.hpp"

namespace steadyslide::app {

Figure make_friction_jump_falling() {
  return two_coatings_figure(
      "friction-jump-falling", "Two coatings, the rougher one at the rear",
      "The same punch sliding to the left: friction falls towards the front, and the pressure vanishes "
      "like `|x|^{-beta}` where it was infinite before, `beta < 0` being the exponent of the other way.",
      Sliding::minus_x);
}

}  // namespace steadyslide::app
