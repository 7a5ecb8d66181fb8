#include "app/figures/two_coatings.hpp"

namespace steadyslide::app {

Figure make_friction_jump_rising() {
  return two_coatings_figure(
      "friction-jump-rising", "Two coatings, the rougher one in front",
      "Sliding to the right, friction rises towards the front: `beta = alpha_- - alpha_+ < 0`, and the "
      "pressure is infinite like `|x|^beta` where it jumps.",
      Sliding::plus_x);
}

}  // namespace steadyslide::app
